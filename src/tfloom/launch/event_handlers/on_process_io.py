"""Handler of what processes read and write."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase
from tfloom.launch.events.process.process_io import ProcessIO
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType

__all__ = ["OnProcessIO"]

Reaction = Callable[[ProcessIO], Any]


class OnProcessIO(OnActionEventBase):
    """Calls functions with what a process reads and writes.

    Args:
        target_action: The action, or a function that returns whether an action is meant; None: any.
        on_stdin: Takes the event, and returns entities to visit or None; None: nothing is done.
        on_stdout: The same for stdout.
        on_stderr: The same for stderr.
        kwargs: As for BaseEventHandler.
    """

    _target_name = "ExecuteLocal"

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_stdin: Reaction | None = None,
        on_stdout: Reaction | None = None,
        on_stderr: Reaction | None = None,
        **kwargs: Any,
    ) -> None:
        self._on_stdin = on_stdin
        self._on_stdout = on_stdout
        self._on_stderr = on_stderr
        super().__init__(
            action_matcher=target_action,
            on_event=self._react,
            target_event_cls=ProcessIO,
            target_action_cls=Action,
            **kwargs,
        )

    def _react(self, event: ProcessIO, _: LaunchContext) -> SomeEntitiesType | None:
        reaction = (
            self._on_stdout if event.from_stdout else self._on_stderr if event.from_stderr else self._on_stdin
        )
        return None if reaction is None else reaction(event)

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        named = {"on_stdin": self._on_stdin, "on_stdout": self._on_stdout, "on_stderr": self._on_stderr}
        return " ".join(f"{name}: '{reaction}'" for name, reaction in named.items() if reaction is not None)
