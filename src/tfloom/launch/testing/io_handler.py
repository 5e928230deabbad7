"""The recorded output of processes. PYTEST_DONT_REWRITE."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator
from typing import Any, cast

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.entities.action import Action
from tfloom.launch.events.process import ProcessIO
from tfloom.launch.testing.active_record import ActiveRecord
from tfloom.launch.testing.assert_output import assertInStream
from tfloom.launch.testing.proc_lookup import (
    CmdArgs,
    NoMatchingProcessException,
    Process,
    process_name,
)
from tfloom.launch.testing.text import Expected

__all__ = ["ActiveIoHandler", "IoHandler"]


class IoHandler:
    """The output of processes, in order, and by process; iterating over it gives all events."""

    def __init__(self) -> None:
        self._events: list[ProcessIO] = []
        self._by_name: dict[str, list[ProcessIO]] = {}
        self._by_action: dict[Action, list[ProcessIO]] = {}

    def track(self, process_name: str) -> None:
        """Have a process known, with no output so far.

        Args:
            process_name: The process's name with its number.
        """
        self._by_name.setdefault(process_name, [])

    def append(self, process_io: ProcessIO) -> None:
        """Record an event."""
        self._events.append(process_io)
        self._by_name.setdefault(process_io.process_name, []).append(process_io)
        self._by_action.setdefault(process_io.action, []).append(process_io)

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(list(self._events))

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of all processes that have printed something, each once."""
        return cast("list[ExecuteProcess]", list(self._by_action))

    def process_names(self) -> list[str]:
        """Return the names of all known processes."""
        return list(self._by_name)

    def __getitem__(self, key: ExecuteLocal | str) -> list[ProcessIO]:
        """Return the events of a process, by its action or its name.

        Raises:
            KeyError: the process is not known.
        """
        if isinstance(key, str):
            return list(self._by_name[key])
        return list(self._by_action.get(key) or self._by_name[process_name(key)])


class ActiveIoHandler(ActiveRecord[ProcessIO, list[ProcessIO]]):
    """The output of processes that still run: all methods can be called on any thread."""

    def __init__(self) -> None:
        self._handler = IoHandler()  # guarded by _changed
        super().__init__(self._handler)

    @property
    def recorded(self) -> IoHandler:
        """The record itself, for the time when no process runs any more."""
        return self._handler

    @property
    def io_event(self) -> threading.Condition:
        """The condition that each event notifies."""
        return self._changed

    def track(self, process_name: str) -> None:
        """Have a process known, with no output so far."""
        with self._changed:
            self._handler.track(process_name)
            self._changed.notify_all()

    def waitFor(
        self,
        expected_output: Expected,
        process: Process = None,
        cmd_args: CmdArgs = None,
        *,
        strict_proc_matching: bool = True,
        output_filter: Callable[[str], str] | None = None,
        timeout: float = 10,
        strip_ansi_escape_sequences: bool = True,
        stream: str = "stderr",
    ) -> bool:
        """Wait until a process has printed what is expected; return whether it has.

        Args:
            expected_output: A text, a pattern, or several, of which each follows the one before.
            process: An action, a part of a process's name, or None for any process.
            cmd_args: With a name: arguments that the process was given.
            strict_proc_matching: With a name: whether more than one match is an error.
            output_filter: Takes the whole output and returns what is searched.
            timeout: [s]; the wait also ends with the launch.
            strip_ansi_escape_sequences: Whether codes for colours are removed first.
            stream: `stdout` or `stderr`, where ROS's logs are.
        """
        try:
            self.assertWaitFor(
                expected_output,
                process,
                cmd_args,
                strict_proc_matching=strict_proc_matching,
                output_filter=output_filter,
                timeout=timeout,
                strip_ansi_escape_sequences=strip_ansi_escape_sequences,
                stream=stream,
            )
        except AssertionError:
            return False
        return True

    def assertWaitFor(
        self,
        expected_output: Expected,
        process: Process = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        **kwargs: Any,
    ) -> None:
        """Assert that a process prints what is expected, in time; the arguments are those of `waitFor`.

        Raises:
            AssertionError: it did not.
        """
        timeout_s = checked_timeout("assertWaitFor", timeout)
        expected = (
            expected_output if isinstance(expected_output, (str, re.Pattern)) else list(expected_output)
        )
        fault = ""

        def is_there() -> bool:
            nonlocal fault
            try:
                assertInStream(self._handler, expected, process, cmd_args, **kwargs)
            except (NoMatchingProcessException, AssertionError) as error:
                fault = str(error)  # a process that has printed nothing so far is not found
                return False
            return True

        # Searched again after the wait, because the end of the launch may have ended it with the output there.
        with self._changed:
            self._changed.wait_for(lambda: is_there() or self._is_closed, timeout_s)
            if is_there():
                return
            waited = "the launch ended" if self._is_closed else f"timed out after {timeout} s"
        raise AssertionError(f"Waiting for output {waited}: {fault}")
