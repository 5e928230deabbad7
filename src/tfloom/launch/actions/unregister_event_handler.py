"""The action that removes an event handler."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.event_handler import BaseEventHandler
from tfloom.launch.launch_context import LaunchContext

__all__ = ["UnregisterEventHandler"]


class UnregisterEventHandler(Action):
    """Removes an event handler.

    Args:
        event_handler: The handler.
        kwargs: As for Action.
    """

    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._event_handler = event_handler

    @property
    def event_handler(self) -> BaseEventHandler:
        """The handler."""
        return self._event_handler

    def execute(self, context: LaunchContext) -> None:
        """Remove the handler."""
        context.unregister_event_handler(self._event_handler)
