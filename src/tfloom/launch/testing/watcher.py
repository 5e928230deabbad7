"""The handler that passes events on to tests."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.event_handler import BaseEventHandler

__all__ = ["Watcher"]


class Watcher(BaseEventHandler):
    """Calls a function with each event of a kind, and leaves the events to the other handlers.

    Args:
        kind: The kind of events.
        function: Takes the event.
    """

    def __init__(self, kind: type[Event], function: Callable[[Any], object]) -> None:
        super().__init__(matcher=lambda event: isinstance(event, kind))
        self._function = function

    def handle(self, event: Event, context: LaunchContext) -> None:
        """Call the function with the event."""
        super().handle(event, context)
        self._function(event)
