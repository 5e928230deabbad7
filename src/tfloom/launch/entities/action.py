"""The base class of actions, and the event of an action's end."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.core.base_classes import Condition, LaunchDescriptionEntity
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.error_places import keep_place, place_of_construction
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext

__all__ = ["Action", "ExecutionComplete"]


class Action(LaunchDescriptionEntity):
    """An entity that is executed when it is visited, if its condition holds.

    Args:
        condition: None: it is always executed.
    """

    def __init__(self, *, condition: Condition | None = None) -> None:
        self._condition = condition
        self.launch_place = place_of_construction()

    @staticmethod
    def parse(entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the keyword arguments that a tag of a launch file gives its constructor."""
        kwargs: dict[str, Any] = {}
        condition = parser.parse_condition(entity)
        if condition is not None:
            kwargs["condition"] = condition
        return Action, kwargs

    @property
    def condition(self) -> Condition | None:
        """Condition of the execution."""
        return self._condition

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities under this one; derived classes override it, in place of the two below."""
        return []

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities under this one, if no condition decides."""
        return self.get_sub_entities() if self._condition is None else []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the entities under this one, if a condition decides."""
        if self._condition is None:
            return []
        return [("Conditionally included by " + self.describe(), self.get_sub_entities())]

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Execute the action if its condition holds."""
        try:
            if self._condition is not None and not self._condition.evaluate(context):
                return None
            following = self.execute(context)
        except Exception as error:
            keep_place(error, getattr(self, "launch_place", ""))
            raise
        complete = ExecutionComplete(action=self)
        if context.would_handle_event(complete):
            future = self.get_asyncio_future()
            if future is None:
                context.emit_event_sync(complete)
            else:
                future.add_done_callback(lambda _: context.emit_event_sync(complete))
        return following

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do what the action stands for, and return the entities to visit next; derived classes override it."""
        return None


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
