"""Handler of the launch's end."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.event import Event
from tfloom.launch.event_handler import BaseEventHandler
from tfloom.launch.events.shutdown import Shutdown
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType
from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities

__all__ = ["OnShutdown"]


class OnShutdown(BaseEventHandler):
    """Visits entities when the launch shuts down.

    Args:
        on_shutdown: The entities, or a function that takes the event and the context and returns them.
        kwargs: As for BaseEventHandler.
    """

    def __init__(
        self,
        *,
        on_shutdown: SomeEntitiesType | Callable[[Shutdown, LaunchContext], SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        self._on_shutdown = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit."""
        super().handle(event, context)
        if callable(self._on_shutdown):
            return self._on_shutdown(event, context)  # type: ignore[arg-type]  # the matcher has checked it
        return self._on_shutdown

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "<actions>" if not callable(self._on_shutdown) else f"{self._on_shutdown}"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        return "event is Shutdown"

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description for people, and the entities to visit, as far as they are known."""
        known = [] if callable(self._on_shutdown) else [self._on_shutdown]
        return super().describe()[0], list(normalize_to_list_of_entities(known))
