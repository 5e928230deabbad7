"""The action that registers an event handler."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.event_handler import BaseEventHandler
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities

__all__ = ["RegisterEventHandler"]


class RegisterEventHandler(Action):
    """Registers an event handler.

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
        """Register the handler."""
        context.register_event_handler(self._event_handler)

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the entities that the handler returns, as far as they are known."""
        text, entities = self._event_handler.describe()
        return [(text, normalize_to_list_of_entities(entities))] if entities else []
