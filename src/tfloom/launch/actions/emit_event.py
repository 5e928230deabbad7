"""The action that emits an event."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.event import Event
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.utilities.class_tools import is_a_subclass

__all__ = ["EmitEvent"]


class EmitEvent(Action):
    """Emits an event.

    Args:
        event: The event.
        kwargs: As for Action.

    Raises:
        RuntimeError: it is no event.
    """

    def __init__(self, *, event: Event, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not is_a_subclass(event, Event):
            raise RuntimeError(f"EmitEvent() expected an event instance, got '{event!r}'.")
        self._event = event

    @property
    def event(self) -> Event:
        """The event."""
        return self._event

    def execute(self, context: LaunchContext) -> None:
        """Emit the event."""
        context.emit_event_sync(self._event)
