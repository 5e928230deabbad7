"""The base classes of event handlers."""

from __future__ import annotations

from collections.abc import Callable

from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    SomeEntitiesType,
    normalize_to_list_of_entities,
)
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_repr

__all__ = ["BaseEventHandler", "EventHandler"]


class BaseEventHandler(HasPrivateNames):
    """Handles the events that a matcher accepts.

    Args:
        matcher: Returns whether an event is handled.
        handle_once: Whether the handler is removed after its first event.
    """

    def __init__(self, *, matcher: Callable[[Event], bool], handle_once: bool = False) -> None:
        self._matcher = matcher
        self._handle_once = handle_once

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def handle_once(self) -> bool:
        """Whether the handler is removed after its first event."""
        return self._handle_once

    @property
    def handler_description(self) -> str | None:
        """What it does, for people."""
        return None

    @property
    def matcher_description(self) -> str | None:
        """Which events it handles, for people."""
        return None

    def matches(self, event: Event) -> bool:
        """Return whether the handler handles an event."""
        return self._matcher(event)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description for people, and the entities that handling returns, as far as they are known."""
        name = type(self).__name__
        text = (
            f"{name}(matcher='{self.matcher_description}', handler='{self.handler_description}', "
            f"handle_once={self.handle_once})"
        )
        return text, []

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Handle an event, which is `context.locals.event`, and return the entities to visit."""
        context.extend_locals({"event": event})
        if self._handle_once:
            context.unregister_event_handler(self)
        return None


class EventHandler(BaseEventHandler):
    """Handles events by entities, which are visited after each.

    Args:
        matcher: Returns whether an event is handled.
        entities: The entities to visit.
        handle_once: Whether the handler is removed after its first event.
    """

    def __init__(
        self,
        *,
        matcher: Callable[[Event], bool],
        entities: SomeEntitiesType | None = None,
        handle_once: bool = False,
    ) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self._entities = None if entities is None else normalize_to_list_of_entities([entities])

    @property
    def entities(self) -> list[LaunchDescriptionEntity] | None:
        """Entities that are visited after each event; None if there are none."""
        return self._entities

    @property
    def handler_description(self) -> str | None:
        """What it does, for people."""
        return "<actions>"

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description for people, and the entities to visit."""
        return super().describe()[0], list(self._entities or [])

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit."""
        super().handle(event, context)
        return self._entities
