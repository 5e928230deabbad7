"""The recorded starts and ends of processes. PYTEST_DONT_REWRITE."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias, cast

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.entities.action import Action
from tfloom.launch.events.process import ProcessExited, ProcessStarted
from tfloom.launch.testing.active_record import ActiveRecord
from tfloom.launch.testing.proc_lookup import (
    CmdArgs,
    NoMatchingProcessException,
    Process,
    process_name,
    resolveProcesses,
)

__all__ = ["ActiveProcInfoHandler", "ProcInfoHandler"]

Info: TypeAlias = ProcessStarted | ProcessExited


class ProcInfoHandler:
    """The last event of each process: its start, or its end with the exit code; iterating gives these."""

    def __init__(self) -> None:
        self._by_action: dict[Action, Info] = {}

    def append(self, process_info: Info) -> None:
        """Record an event."""
        self._by_action[process_info.action] = process_info

    def __iter__(self) -> Iterator[Info]:
        return iter(list(self._by_action.values()))

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of all processes."""
        return cast("list[ExecuteProcess]", list(self._by_action))

    def process_names(self) -> list[str]:
        """Return the names of all processes."""
        return [event.process_name for event in self._by_action.values()]

    def __getitem__(self, key: ExecuteLocal | str) -> Info:
        """Return the last event of a process, by its action or its name.

        Raises:
            KeyError: the process is not known.
        """
        if not isinstance(key, str):
            return self._by_action[key]
        for event in self._by_action.values():
            if event.process_name == key:
                return event
        raise KeyError(key)


class ActiveProcInfoHandler(ActiveRecord[Info, Info]):
    """The starts and ends of processes that still run: all methods can be called on any thread."""

    def __init__(self) -> None:
        self._handler = ProcInfoHandler()  # guarded by _changed
        super().__init__(self._handler)

    @property
    def recorded(self) -> ProcInfoHandler:
        """The record itself, for the time when no process runs any more."""
        return self._handler

    def assertWaitForShutdown(
        self, process: Process, cmd_args: CmdArgs = None, *, timeout: float | None = 10
    ) -> None:
        """Assert that a process exits in time.

        Args:
            process: An action, or a part of a process's name.
            cmd_args: With a name: arguments that the process was given.
            timeout: [s].

        Raises:
            AssertionError: it did not.
        """
        self._wait(process, cmd_args, timeout, "exit", is_end=True)

    def assertWaitForStartup(
        self, process: Process, cmd_args: CmdArgs = None, *, timeout: float | None = 10
    ) -> None:
        """Assert that a process is started in time; one that has exited since then was.

        Args:
            process: An action, or a part of a process's name.
            cmd_args: With a name: arguments that the process was given.
            timeout: [s].

        Raises:
            AssertionError: it was not.
        """
        self._wait(process, cmd_args, timeout, "start", is_end=False)

    def _wait(
        self, process: Process, cmd_args: CmdArgs, timeout: float | None, what: str, *, is_end: bool
    ) -> None:
        fault = ""
        timeout_s = checked_timeout("assertWaitForShutdown" if is_end else "assertWaitForStartup", timeout)

        def has_happened() -> bool:
            nonlocal fault
            try:
                action = resolveProcesses(self._handler, process=process, cmd_args=cmd_args)[0]
            except NoMatchingProcessException as error:
                fault = f": {error}"
                return False
            fault = f": {process_name(action)} runs" if is_end else ""
            return not is_end or isinstance(self._handler[action], ProcessExited)

        with self._changed:
            self._changed.wait_for(lambda: has_happened() or self._is_closed, timeout_s)
            if has_happened():
                return
            waited = "The launch ended, waiting" if self._is_closed else "Timed out waiting"
        raise AssertionError(f"{waited} for process to {what} (at most {timeout} s){fault}")
