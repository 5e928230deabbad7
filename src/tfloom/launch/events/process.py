"""Events of processes, and what selects a process."""

from __future__ import annotations

import signal
from collections.abc import Callable, Mapping
from typing import Any

from tfloom.launch.core.event import Event
from tfloom.launch.entities.action import Action

__all__ = [
    "ProcessExited",
    "ProcessIO",
    "ProcessStarted",
    "ProcessStderr",
    "ProcessStdin",
    "ProcessStdout",
    "ProcessTargetedEvent",
    "RunningProcessEvent",
    "ShutdownProcess",
    "SignalProcess",
    "matches_action",
    "matches_executable",
    "matches_name",
    "matches_pid",
]


class RunningProcessEvent(Event):
    """Something has happened to a process.

    Args:
        action: The action that started it, an ExecuteLocal.
        name: Its name, with its number.
        cmd: Its command line.
        cwd: The folder that it was started in; None: the launch's.
        env: Its environment variables; None: the launch's.
        pid: Its process id.
    """

    name = "launch.events.process.RunningProcessEvent"

    def __init__(
        self,
        *,
        action: Action,
        name: str,
        cmd: list[str],
        cwd: str | None,
        env: Mapping[str, str] | None,
        pid: int,
    ) -> None:
        self._action = action
        self._process_name = name
        self._cmd = cmd
        self._cwd = cwd
        self._env = env
        self._pid = pid

    @property
    def action(self) -> Action:
        """Action that started the process."""
        return self._action

    @property
    def execute_process_action(self) -> Action:
        """The action, by a former name."""
        return self._action

    @property
    def process_name(self) -> str:
        """Name of the process, with its number."""
        return self._process_name

    @property
    def cmd(self) -> list[str]:
        """Command line of the process."""
        return self._cmd

    @property
    def cwd(self) -> str | None:
        """Folder that the process was started in; None: the launch's."""
        return self._cwd

    @property
    def env(self) -> Mapping[str, str] | None:
        """Environment variables of the process; None: the launch's."""
        return self._env

    @property
    def pid(self) -> int:
        """Process id that the system has given."""
        return self._pid


class ProcessTargetedEvent(Event):
    """Something is to be done to some of the processes.

    Args:
        process_matcher: Returns whether it is to be done to the process of an action.
    """

    name = "launch.events.process.ProcessTargetedEvent"

    def __init__(self, *, process_matcher: Callable[[Any], bool]) -> None:
        self._process_matcher = process_matcher

    @property
    def process_matcher(self) -> Callable[[Any], bool]:
        """Function that returns whether it is to be done to the process of an action."""
        return self._process_matcher


ProcessMatcher = Callable[[Any], bool]


def matches_action(target_action: Action) -> Callable[[Action], bool]:
    """Return a function that returns whether an action is `target_action`."""
    return lambda action: action is target_action


def matches_pid(pid: int) -> ProcessMatcher:
    """Return a function that returns whether an action's process has a process id."""
    return lambda action: bool(action.process_details) and action.process_details["pid"] == pid


def matches_name(name: str) -> ProcessMatcher:
    """Return a function that returns whether an action's process has a name, with or without its number."""

    def matches(action: Any) -> bool:
        final_name = str((action.process_details or {}).get("name") or action.process_description.final_name)
        head, _, number = final_name.rpartition("-")
        return name == final_name or (number.isdigit() and name == head)

    return matches


def matches_executable(executable: str) -> ProcessMatcher:
    """Return a function that returns whether an action's process runs a program, by its path or its file name."""

    def matches(action: Any) -> bool:
        cmd = (action.process_details or {}).get("cmd") or action.process_description.final_cmd
        return bool(cmd) and executable in (cmd[0], cmd[0].rpartition("/")[2])

    return matches


class ProcessStarted(RunningProcessEvent):
    """A process has started.

    Args:
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStarted"

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)


class ProcessExited(RunningProcessEvent):
    """A process has ended.

    Args:
        returncode: Its exit code; minus a signal's number if that ended it.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessExited"

    def __init__(self, *, returncode: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._returncode = returncode

    @property
    def returncode(self) -> int:
        """Exit code; minus a signal's number if that ended the process."""
        return self._returncode


class ProcessIO(RunningProcessEvent):
    """A process has read or written something.

    Args:
        text: What was written, as bytes; not necessarily whole lines.
        fd: The process's descriptor: 0 stdin, 1 stdout, 2 stderr.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessIO"

    def __init__(self, *, text: bytes, fd: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._text = text
        self._fd = fd

    @property
    def text(self) -> bytes:
        """What was written, as bytes; not necessarily whole lines."""
        return self._text

    @property
    def from_stdin(self) -> bool:
        """Whether they went to the process's stdin."""
        return self._fd == 0

    @property
    def from_stdout(self) -> bool:
        """Whether they came from the process's stdout."""
        return self._fd == 1

    @property
    def from_stderr(self) -> bool:
        """Whether they came from the process's stderr."""
        return self._fd == 2


class ProcessStdout(ProcessIO):
    """A process has written to its stdout.

    Args:
        text: What was written, as bytes.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStdout"

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=1, **kwargs)


class ProcessStderr(ProcessIO):
    """A process has written to its stderr.

    Args:
        text: What was written, as bytes.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStderr"

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=2, **kwargs)


class ProcessStdin(ProcessTargetedEvent):
    """Writes to the stdin of processes.

    Args:
        text: What is written, as bytes or text.
        kwargs: As for ProcessTargetedEvent.
    """

    name = "launch.events.process.ProcessStdin"

    def __init__(self, *, text: bytes | str, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._text = text.encode() if isinstance(text, str) else text

    @property
    def text(self) -> bytes:
        """What is written, as bytes."""
        return self._text


class ShutdownProcess(ProcessTargetedEvent):
    """Ends processes: by SIGINT, then SIGTERM, then SIGKILL."""

    name = "launch.events.process.ShutdownProcess"


class SignalProcess(ProcessTargetedEvent):
    """Sends a signal to processes.

    Args:
        signal_number: The signal: its number, its name ("SIGINT"), or one of `signal.Signals`.
        process_matcher: Returns whether it is sent to the process of an action.

    Raises:
        ValueError: there is no such signal.
    """

    name = "launch.events.process.SignalProcess"

    def __init__(
        self, *, signal_number: str | int | signal.Signals, process_matcher: Callable[[Any], bool]
    ) -> None:
        super().__init__(process_matcher=process_matcher)
        if isinstance(signal_number, str):
            name = signal_number if signal_number.startswith("SIG") else f"SIG{signal_number}"
            try:
                self._signal = signal.Signals[name]
            except KeyError:
                raise ValueError(f"'{signal_number}' is not a name of a signal, as SIGINT is one") from None
        else:
            self._signal = signal.Signals(signal_number)

    @property
    def signal(self) -> signal.Signals:
        """Signal that is sent to the processes."""
        return self._signal

    @property
    def signal_name(self) -> str:
        """Name of the signal, as "SIGINT"."""
        return self._signal.name
