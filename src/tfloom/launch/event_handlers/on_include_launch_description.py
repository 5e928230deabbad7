"""Handler that adds a description to the launch."""

from __future__ import annotations

from typing import Any, cast

from tfloom.launch.event import Event
from tfloom.launch.event_handler import BaseEventHandler
from tfloom.launch.events.include_launch_description import IncludeLaunchDescription
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType

__all__ = ["OnIncludeLaunchDescription"]


class OnIncludeLaunchDescription(BaseEventHandler):
    """Visits the description of an IncludeLaunchDescription event. The launch service has one.

    Args:
        kwargs: As for BaseEventHandler.
    """

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the description."""
        super().handle(event, context)
        return cast("IncludeLaunchDescription", event).launch_description

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "returns the launch_description in the event"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        return "event issubclass of launch.events.IncludeLaunchDescription"
