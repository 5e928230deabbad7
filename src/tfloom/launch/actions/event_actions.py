"""Actions that emit events, and that add and remove event handlers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.utilities.class_tools import is_a_subclass
from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities

__all__ = ["EmitEvent", "RegisterEventHandler", "UnregisterEventHandler"]


class EmitEvent(Action):
    """Emits an event.

    Args:
        event: The event.
        kwargs: As for Action.

    Raises:
        RuntimeError: it is not an event.
    """

    def __init__(self, *, event: Event, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not is_a_subclass(event, Event):
            raise RuntimeError(f"EmitEvent() expected an event instance, got '{event!r}'.")
        self._event = event

    @property
    def event(self) -> Event:
        """Event that is emitted."""
        return self._event

    def execute(self, context: LaunchContext) -> None:
        """Add the event to those that the launch handles."""
        context.emit_event_sync(self._event)


class _OfHandler(Action):
    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._event_handler = event_handler

    @property
    def event_handler(self) -> BaseEventHandler:
        """Handler that is registered or removed."""
        return self._event_handler


class RegisterEventHandler(_OfHandler):
    """Registers an event handler.

    Args:
        event_handler: The handler.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Add the handler to those that are asked for each event."""
        context.register_event_handler(self._event_handler)

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the entities that the handler returns, as far as they are known."""
        text, entities = self._event_handler.describe()
        return [(text, normalize_to_list_of_entities(entities))] if entities else []


class UnregisterEventHandler(_OfHandler):
    """Removes an event handler.

    Args:
        event_handler: The handler.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Remove the handler, which gets no later event."""
        context.unregister_event_handler(self._event_handler)
