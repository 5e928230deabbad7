"""Processes that a test starts by itself, in a launch that runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.launch_events import IncludeLaunchDescription
from tfloom.launch.events.process import ProcessExited, ProcessStarted, ShutdownProcess, matches_action
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.testing.assert_output import text_of
from tfloom.launch.testing.io_handler import ActiveIoHandler
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler
from tfloom.launch.utilities.argument_types import ensure_argument_type

__all__ = ["ProcessProxy", "launch_process"]


class ProcessProxy:
    """What a test sees of one process.

    Args:
        process_action: Its action.
        proc_info: The starts and ends of the launch's processes.
        proc_output: The output of the launch's processes.
        output_filter: Takes a text that the process printed and returns what counts of it; None for all.
    """

    def __init__(
        self,
        process_action: ExecuteProcess,
        proc_info: ActiveProcInfoHandler,
        proc_output: ActiveIoHandler,
        *,
        output_filter: Callable[[str], str] | None = None,
    ) -> None:
        self._action = process_action
        self._proc_info = proc_info
        self._proc_output = proc_output
        self._output_filter = output_filter

    @property
    def target_process_action(self) -> ExecuteProcess:
        """Action of the process."""
        return self._action

    @property
    def running(self) -> bool:
        """Whether the process was started and has not exited."""
        return isinstance(self._last_event(), ProcessStarted)

    @property
    def terminated(self) -> bool:
        """Whether the process has exited."""
        return isinstance(self._last_event(), ProcessExited)

    @property
    def exit_code(self) -> int:
        """Exit code of the process; RuntimeError if it has not exited."""
        info = self._last_event()
        if not isinstance(info, ProcessExited):
            raise RuntimeError("the process has no exit code, because it has not exited")  # of a state
        return info.returncode

    @property
    def stdout(self) -> str:
        """What it has printed to its standard output."""
        return self._text("stdout")

    @property
    def stderr(self) -> str:
        """What it has printed to its standard error."""
        return self._text("stderr")

    @property
    def output(self) -> str:
        """What it has printed to both, in the order in which it came."""
        return self._text("")

    def wait_for_shutdown(self, timeout: float | None = None) -> bool:
        """Wait until the process exits; return whether it has.

        Args:
            timeout: [s]; None for no limit.
        """
        try:
            self._proc_info.assertWaitForShutdown(self._action, timeout=timeout)
        except AssertionError:
            return False
        return True

    def wait_for_output(
        self, condition: Callable[[str], object] | None = None, timeout: float | None = None
    ) -> bool:
        """Wait until the process has printed something; return whether it has.

        Args:
            condition: Takes all that it has printed, and returns whether this will do; None for any text.
            timeout: [s]; None for no limit.
        """
        timeout_s = checked_timeout("wait_for_output", timeout)
        changed = self._proc_output.io_event
        with changed:
            return changed.wait_for(lambda: bool((condition or bool)(self.output)), timeout_s)

    def _last_event(self) -> object:
        try:
            return self._proc_info[self._action]
        except KeyError:
            return None

    def _text(self, stream: str) -> str:
        try:
            output = self._proc_output[self._action]
        except KeyError:
            return ""
        text = text_of(output, stream)
        return text if self._output_filter is None else self._output_filter(text)


@contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteProcess,
    proc_info: ActiveProcInfoHandler,
    proc_output: ActiveIoHandler,
    **kwargs: Any,
) -> Iterator[ProcessProxy]:
    """Start a process in a launch that runs, and shut it down at the end of the block.

    Args:
        launch_service: The launch, of a test's argument of this name.
        process_action: The action.
        proc_info: The starts and ends of the launch's processes.
        proc_output: The output of the launch's processes.
        kwargs: As for ProcessProxy.

    Raises:
        TypeError: `process_action` is not an ExecuteProcess action.
        AssertionError: the process does not start, or does not exit.
    """
    ensure_argument_type(process_action, ExecuteProcess, "process_action", "launch_process")
    launch_service.emit_event(IncludeLaunchDescription(LaunchDescription([process_action])))
    proc_info.assertWaitForStartup(process_action, timeout=30)
    try:
        yield ProcessProxy(process_action, proc_info, proc_output, **kwargs)
    finally:
        if not isinstance(proc_info[process_action], ProcessExited):
            launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(process_action)))
            proc_info.assertWaitForShutdown(process_action, timeout=30)
