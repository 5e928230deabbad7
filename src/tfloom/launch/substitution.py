"""The base class of substitutions."""

from __future__ import annotations

from tfloom.launch.launch_context import LaunchContext
from tfloom.ros_guard import ros_repr

__all__ = ["Substitution"]


class Substitution:
    """A text that is only known when the launch runs."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the text; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `perform` of its own.
        """
        raise NotImplementedError(
            f"{type(self).__name__} has no method 'perform', which returns the substitution's text"
        )

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)
