"""The end of an action."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.event import Event

__all__ = ["ExecutionComplete"]


class ExecutionComplete(Event):
    """An action has ended that went on after its visit.

    Args:
        action: The action.
    """

    name = "launch.events.ExecutionComplete"

    def __init__(self, *, action: Action) -> None:
        self._action = action

    @property
    def action(self) -> Action:
        """The action."""
        return self._action
