"""The processes that a test names: by their action, or by a part of their name and their arguments."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final, Protocol

from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.ros_imports.guard import ros_home

__all__ = ["NO_CMD_ARGS", "CmdArgs", "NoMatchingProcessException", "Process", "resolveProcesses"]


class _NoCmdArgs:
    """The type of NO_CMD_ARGS, which stands for a process without arguments."""

    def __repr__(self) -> str:
        return "NO_CMD_ARGS"


NO_CMD_ARGS: Final = _NoCmdArgs()
"""In place of arguments: a process that was started without any."""

Process = ExecuteLocal | str | None
"""An action, a part of a process's name, or None for all processes."""
CmdArgs = Sequence[str] | str | _NoCmdArgs | None
"""An argument, several that are all there, NO_CMD_ARGS, or None for any."""


class NoMatchingProcessException(Exception):
    """No process matches what was named."""

    __module__ = ros_home("launch_testing.util.proc_lookup", __name__)


class HasProcesses(Protocol):
    """What records events of processes: an IoHandler or a ProcInfoHandler."""

    def processes(self) -> Iterable[ExecuteLocal]:
        """Return the actions of the processes, each once."""


def resolveProcesses(
    info_obj: HasProcesses,
    *,
    process: Process = None,
    cmd_args: CmdArgs = None,
    strict_proc_matching: bool = True,
) -> list[ExecuteLocal]:
    """Return the actions of the processes that match, at least one.

    Args:
        info_obj: Recorded events of processes.
        process: An action, a part of a process's name, or None for all processes.
        cmd_args: With a name: an argument or several, all of which the process was given; NO_CMD_ARGS, or None for any.
        strict_proc_matching: With a name: whether more than one match is an error.

    Raises:
        NoMatchingProcessException: no recorded process matches.
        Exception: several processes match a name, and `strict_proc_matching` is set.
        TypeError: `process` is neither an action nor a text.
    """
    recorded_actions = list(info_obj.processes())
    if process is None or process == "":
        if not recorded_actions:
            raise NoMatchingProcessException("No processes were recorded")
        return recorded_actions
    if isinstance(process, ExecuteLocal):
        if process not in recorded_actions:
            raise NoMatchingProcessException(f"No data recorded for proc {_describe(process)}")
        return [process]
    if not isinstance(process, str):
        raise TypeError(f"process must be an ExecuteLocal action or a text, and is {process!r}")
    matches = [
        action
        for action in recorded_actions
        if process in process_name(action) and _has_arguments(action, cmd_args)
    ]
    if not matches:
        arguments = "" if cmd_args is None else f" and arguments {cmd_args!r}"
        raise NoMatchingProcessException(
            f"Did not find any process with '{process}' in its name{arguments}; "
            f"recorded are: {_names(recorded_actions)}"
        )
    if strict_proc_matching and len(matches) > 1:
        raise Exception(
            f"Found multiple processes with '{process}' in their names: {_names(matches)}; "
            "name one of them, give cmd_args, or set strict_proc_matching=False"
        )
    return matches


def process_name(process: ExecuteLocal) -> str:
    """Return the name of a process with its number; of one that was not started, what is known of it."""
    details = process.process_details
    if details is None:
        return str(getattr(process, "name", None) or process.process_description.name or "")
    return str(details["name"])


def _has_arguments(process: ExecuteLocal, cmd_args: CmdArgs) -> bool:
    if cmd_args is None:
        return True
    details = process.process_details
    arguments: list[str] = [] if details is None else list(details["cmd"])[1:]
    if isinstance(cmd_args, _NoCmdArgs):
        return not arguments
    expected_arguments = [cmd_args] if isinstance(cmd_args, str) else cmd_args
    return all(argument in arguments for argument in expected_arguments)


def _describe(process: ExecuteLocal) -> str:
    """Return the name of a process, or its command line if that is of texts alone."""
    if process.process_details is not None:
        return process_name(process)
    executable = process.process_description
    words = list(executable.final_cmd or ())
    for word in () if words else executable.cmd:
        if all(isinstance(part, TextSubstitution) for part in word):
            words.append("".join(part.text for part in word if isinstance(part, TextSubstitution)))
        else:
            return "Unknown: it was not started, and its command line has substitutions"
    return f"'{' '.join(words)}', which was not started"


def _names(processes: Iterable[ExecuteLocal]) -> str:
    return ", ".join(process_name(process) for process in processes) or "none"
