"""Assertions on the exit codes of processes. PYTEST_DONT_REWRITE."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterable, Sequence
from typing import Protocol

from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.events.process import ProcessExited
from tfloom.launch.testing.proc_lookup import CmdArgs, Process, process_name, resolveProcesses

__all__ = [
    "EXIT_FORCED",
    "EXIT_OK",
    "EXIT_SIGINT",
    "EXIT_SIGKILL",
    "EXIT_SIGQUIT",
    "EXIT_SIGSEGV",
    "assertExitCodes",
]

EXIT_OK = 0
EXIT_FORCED = 1
"""Of a process that Windows ended."""
EXIT_SIGINT = 130
EXIT_SIGQUIT = 131
EXIT_SIGKILL = 137
EXIT_SIGSEGV = 139

_ALLOWED = [EXIT_OK, EXIT_FORCED] if os.name == "nt" else [EXIT_OK]


class ProcInfo(Protocol):
    """What has the ends of processes: a ProcInfoHandler."""

    def processes(self) -> Iterable[ExecuteProcess]:
        """Return the actions of the processes."""

    def __getitem__(self, key: ExecuteLocal | str) -> object: ...


def assertExitCodes(
    proc_info: ProcInfo,
    allowable_exit_codes: Sequence[int] = _ALLOWED,
    process: Process = None,
    cmd_args: CmdArgs = None,
    *,
    strict_proc_matching: bool = True,
) -> None:
    """Assert that processes have exited with one of some codes.

    Args:
        proc_info: The ends of processes, of a test's argument of this name.
        allowable_exit_codes: The codes; a process that a signal ended has the negative number of the signal.
        process: An action, a part of a process's name, or None for all processes.
        cmd_args: With a name: arguments that the process was given.
        strict_proc_matching: With a name: whether more than one match is an error.

    Raises:
        AssertionError: a process has another code, or has not exited.
        NoMatchingProcessException: no process matches.
    """
    for action in resolveProcesses(
        proc_info, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching
    ):
        event = proc_info[action]
        if not isinstance(event, ProcessExited):
            raise AssertionError(f"Proc {process_name(action)} has not exited")  # of a test
        if event.returncode not in allowable_exit_codes:
            allowed = ", ".join(str(code) for code in allowable_exit_codes)
            raise AssertionError(
                f"Proc {event.process_name} exited with code {describe_exit_code(event.returncode)}, "
                f"and not with one of: {allowed}"
            )


def describe_exit_code(code: int) -> str:
    """Return an exit code as a text, with the name of the signal if one ended the process."""
    try:
        return str(code) if code >= 0 else f"{code} ({signal.Signals(-code).name})"
    except ValueError:
        return str(code)
