"""Actions of tests: programs that are tests, one that runs until the launch ends, the sign that a launch is ready.

Also the handler that passes events on to tests.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.events.event_handlers import OnProcessStart
from tfloom.launch.events.process import ShutdownProcess, matches_action
from tfloom.launch.logs.logging import get_logger

__all__ = ["GTest", "KeepAliveProc", "PyTest", "ReadyToTest", "Test", "TestsCanBegin", "Watcher"]
_PROGRAM = """\
import signal, sys, time
signal.signal(signal.SIGINT, lambda *_: sys.exit(0))
signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
if hasattr(signal, "pthread_sigmask"):
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT, signal.SIGTERM])
while True:
    time.sleep(3600)
"""


class Test(ExecuteProcess):
    """Runs a test as a process.

    Args:
        timeout: Time after which the process is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    __test__ = False  # for pytest

    def __init__(self, *, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._timeout = checked_timeout("Test", timeout)

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
            period=self._timeout, actions=[OpaqueFunction(function=self._end)], cancel_on_shutdown=True
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


class GTest(Test):
    """Runs a program that GoogleTest made.

    Args:
        path: Of the program.
        timeout: Time after which it is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[path], timeout=timeout, **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """Path of the program."""
        return self._path


class PyTest(Test):
    """Runs pytest.

    Args:
        path: Of the file or the folder with tests.
        timeout: Time after which it is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[sys.executable, "-m", "pytest", path], timeout=timeout, **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """Path of the file or the folder with tests."""
        return self._path


class TestsCanBegin(Event):
    """The launch has come to its ReadyToTest action."""

    __test__ = False  # for pytest
    name = "tfloom.launch.testing.TestsCanBegin"


class ReadyToTest(Action):
    """Lets the tests of a launch begin; by itself, or where a handler of events has it, once that event has come."""

    def describe(self) -> str:
        """Return the class name."""
        return "ReadyToTest()"

    def execute(self, context: LaunchContext) -> None:
        """Emit the event that starts the tests; in a launch without tests nothing handles it."""
        event = TestsCanBegin()
        if context.would_handle_event(event):
            context.emit_event_sync(event)


class _KeepAlive(ExecuteProcess):
    """Runs the program, which gets a signal that is sent before it has its handlers once it has them."""

    _blocks_signals = True


def KeepAliveProc() -> ExecuteProcess:
    """Return the action of a process that exits with 0 when the launch shuts down.

    A launch ends with its last process, and fails tests that still run. Where all processes under test end by
    themselves, this one keeps the launch going.
    """
    return _KeepAlive(cmd=[sys.executable, "-S", "-c", _PROGRAM], name="keep_alive")


class Watcher(BaseEventHandler):
    """Calls a function with each event of a kind, and leaves the events to the other handlers.

    Args:
        kind: The kind of events.
        function: Takes the event.
    """

    def __init__(self, kind: type[Event], function: Callable[[Any], object]) -> None:
        super().__init__(matcher=lambda event: isinstance(event, kind))
        self._function = function

    def handle(self, event: Event, context: LaunchContext) -> None:
        """Call the function with the event."""
        super().handle(event, context)
        self._function(event)
