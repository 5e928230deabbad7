"""When the processes of a test are ready."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeEntitiesType
from tfloom.launch.events.event_handlers import OnProcessIO
from tfloom.launch.events.process import ProcessIO

__all__ = [
    "DEFAULT_TIMEOUT_S",
    "ReadyAggregator",
    "StdoutReadyListener",
    "ready_to_test_action_timeout",
    "timeout_of",
]


class ReadyAggregator:
    """Calls a function when `ready_fn` has been called for the last process, on any thread.

    Args:
        callback: Called once, on the thread of that call.
        num_needed: Number of calls.
    """

    def __init__(self, callback: Callable[[], object], num_needed: int) -> None:
        self._callback = callback
        self._missing = num_needed  # guarded by _lock
        self._lock = threading.Lock()

    def ready_fn(self) -> None:
        """Count one process as ready."""
        with self._lock:
            self._missing -= 1
            is_last = self._missing == 0
        if is_last:
            self._callback()


DEFAULT_TIMEOUT_S = 15.0
_ATTRIBUTE = "__ready_to_test_action_timeout__"
_Function = TypeVar("_Function", bound=Callable[..., object])


def ready_to_test_action_timeout(timeout: float) -> Callable[[_Function], _Function]:
    """Return a decorator of `generate_test_description` that sets its time until ReadyToTest.

    Args:
        timeout: [s], instead of 15.
    """
    timeout_s = checked_timeout("ready_to_test_action_timeout", timeout)

    def decorate(function: _Function) -> _Function:
        setattr(function, _ATTRIBUTE, math.inf if timeout_s is None else timeout_s)
        return function

    return decorate


def timeout_of(function: object) -> float:
    """Return the time that a test description has until its ReadyToTest action [s]."""
    return float(getattr(function, _ATTRIBUTE, DEFAULT_TIMEOUT_S))


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
