"""The error of a substitution that has no text."""

from __future__ import annotations

from tfloom.ros_guard import ros_home

__all__ = ["SubstitutionFailure"]


class SubstitutionFailure(RuntimeError):  # noqa: N818  # ROS's name
    """A substitution cannot be performed.

    Args:
        msg: What is wrong.
    """

    __module__ = ros_home("launch.substitutions.substitution_failure", __name__)

    def __init__(self, msg: object) -> None:
        super().__init__(msg)
