"""The end of an action."""

from __future__ import annotations

from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_description_entity import LaunchDescriptionEntity

__all__ = ["ExecutionComplete"]


class ExecutionComplete(Event):
    """An action has ended that went on after its visit.

    Args:
        action: The action.
    """

    name = "launch.events.ExecutionComplete"

    def __init__(self, *, action: LaunchDescriptionEntity) -> None:
        self._action = action

    @property
    def action(self) -> LaunchDescriptionEntity:
        """Action that is complete."""
        return self._action
