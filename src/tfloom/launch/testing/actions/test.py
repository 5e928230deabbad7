"""Processes that are tests: they are ended after a time."""

from __future__ import annotations

from typing import Any

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.opaque_function import OpaqueFunction
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.event_handlers.on_process_start import OnProcessStart
from tfloom.launch.events.matchers import matches_action
from tfloom.launch.events.process.shutdown_process import ShutdownProcess
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.logging import get_logger

__all__ = ["Test"]


class Test(ExecuteProcess):
    """Runs a test as a process.

    Args:
        timeout: Time after which the process is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    __test__ = False  # for pytest

    def __init__(self, *, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._timeout = timeout

    @property
    def timeout(self) -> float | None:
        """Time after which the process is shut down [s]; None for no limit."""
        return self._timeout

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the process, and the timer with it."""
        started = super().execute(context)
        if self._timeout is None:
            return started
        timer = TimerAction(
            period=float(self._timeout), actions=[OpaqueFunction(function=self._end)], cancel_on_shutdown=True
        )
        on_start = OnProcessStart(target_action=self, on_start=[timer], handle_once=True)
        context.register_event_handler(on_start)
        return started

    def _end(self, context: LaunchContext) -> None:
        if self.return_code is None:
            get_logger("launch_testing").error(
                f"{self.name} ran for more than {self._timeout} s, and is shut down"
            )
            context.emit_event_sync(ShutdownProcess(process_matcher=matches_action(self)))
