"""Actions that emit events, as that of the launch's end, and that add and remove event handlers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    normalize_to_list_of_entities,
)
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.events.launch_events import Shutdown as ShutdownEvent
from tfloom.launch.events.process import ProcessExited
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.argument_types import is_a_subclass

__all__ = ["EmitEvent", "RegisterEventHandler", "Shutdown", "UnregisterEventHandler"]


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


@expose_action("shutdown")
class Shutdown(EmitEvent):
    """Ends the launch, and all its processes.

    Args:
        reason: Why, for people.
        kwargs: As for Action.
    """

    def __init__(self, *, reason: str = "reason not given", **kwargs: Any) -> None:
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the arguments of its constructor."""
        _, kwargs = super().parse(entity, parser)
        if (reason := entity.get_attr("reason", optional=True)) is not None:
            kwargs["reason"] = reason
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Emit the event, and log the process whose end was the reason, if one was."""
        event = context.get_locals_as_dict().get("event")
        if isinstance(event, ProcessExited):
            get_logger("launch").info(
                "process[%s] was required: shutting down launched system", event.process_name
            )
        super().execute(context)
