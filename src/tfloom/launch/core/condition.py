"""The base class of conditions."""

from __future__ import annotations

from collections.abc import Callable

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.ros_imports.guard import ros_repr

__all__ = ["Condition"]


class Condition:
    """A predicate that decides, when an action is visited, whether it is executed.

    Args:
        predicate: Called with the context; None: a condition that never holds.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    def __repr__(self) -> str:
        return ros_repr(self)

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition holds now."""
        return self._predicate is not None and self._predicate(context)
