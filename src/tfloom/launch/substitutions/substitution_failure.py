"""The error of a substitution that has no text."""

from __future__ import annotations

__all__ = ["SubstitutionFailure"]


class SubstitutionFailure(RuntimeError):  # noqa: N818  # ROS's name
    """A substitution cannot be performed.

    Args:
        msg: What is wrong.
    """

    def __init__(self, msg: object) -> None:
        super().__init__(msg)
