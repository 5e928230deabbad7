"""Actions that follow a line of a process's output."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.event_handlers.on_process_io import OnProcessIO
from tfloom.launch.events.process.process_io import ProcessIO
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType

__all__ = ["StdoutReadyListener"]


class StdoutReadyListener(OnProcessIO):
    """Handler that runs actions when a process prints a text to its standard output.

    Args:
        target_action: The process, or None for any.
        ready_txt: The text, or a part of it.
        actions: What is run.
        kwargs: As for OnProcessIO.
    """

    def __init__(
        self,
        *,
        target_action: ExecuteProcess | None = None,
        ready_txt: str,
        actions: Iterable[LaunchDescriptionEntity],
        **kwargs: Any,
    ) -> None:
        self._ready_txt = ready_txt
        self._ready_actions = list(actions)
        super().__init__(target_action=target_action, on_stdout=self._on_stdout, **kwargs)

    def _on_stdout(self, process_io: ProcessIO) -> SomeEntitiesType | None:
        return self._ready_actions if self._ready_txt in process_io.text.decode("utf-8", "replace") else None

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a text for printed descriptions, and the actions."""
        return f"StdoutReadyListener(ready_txt={self._ready_txt!r})", list(self._ready_actions)
