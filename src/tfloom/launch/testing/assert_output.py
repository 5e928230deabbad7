"""Assertions on the output of processes. PYTEST_DONT_REWRITE."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Protocol

from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.events.process import ProcessIO
from tfloom.launch.testing.proc_lookup import CmdArgs, Process, process_name, resolveProcesses
from tfloom.launch.testing.text import Expected, build_text_match, remove_ansi_escape_sequences

__all__ = ["assertDefaultStream", "assertInStderr", "assertInStdout", "assertInStream"]


class ProcOutput(Protocol):
    """What has the output of processes: an IoHandler."""

    def processes(self) -> Iterable[ExecuteProcess]:
        """Return the actions of the processes."""

    def __getitem__(self, key: ExecuteLocal | str) -> Sequence[ProcessIO]: ...


def assertInStdout(
    proc_output: ProcOutput,
    expected_output: Expected,
    process: Process,
    cmd_args: CmdArgs = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
) -> None:
    """Assert that a process has printed to its standard output what is expected; see `assertInStream`."""
    assertInStream(
        proc_output,
        expected_output,
        process,
        cmd_args,
        output_filter=output_filter,
        strict_proc_matching=strict_proc_matching,
        strip_ansi_escape_sequences=strip_ansi_escape_sequences,
        stream="stdout",
    )


def assertInStderr(
    proc_output: ProcOutput,
    expected_output: Expected,
    process: Process,
    cmd_args: CmdArgs = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
) -> None:
    """Assert that a process has printed to its standard error what is expected; see `assertInStream`."""
    assertInStream(
        proc_output,
        expected_output,
        process,
        cmd_args,
        output_filter=output_filter,
        strict_proc_matching=strict_proc_matching,
        strip_ansi_escape_sequences=strip_ansi_escape_sequences,
        stream="stderr",
    )


def assertInStream(
    proc_output: ProcOutput,
    expected_output: Expected,
    process: Process,
    cmd_args: CmdArgs = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
    stream: str = "stderr",
) -> None:
    """Assert that a process has printed what is expected.

    Args:
        proc_output: Recorded output, of a test's argument of this name.
        expected_output: A text, a pattern, or several, of which each follows the one before.
        process: An action, a part of a process's name, or None for any process.
        cmd_args: With a name: arguments that the process was given.
        output_filter: Takes the whole output and returns what is searched.
        strict_proc_matching: With a name: whether more than one match is an error.
        strip_ansi_escape_sequences: Whether codes for colours are removed first.
        stream: `stdout` or `stderr`, where ROS's logs are.

    Raises:
        AssertionError: it is not there.
        NoMatchingProcessException: no process matches.
        ValueError: `stream` is neither.
    """
    if stream not in {"stdout", "stderr"}:
        raise ValueError(f"stream must be 'stdout' or 'stderr', and is {stream!r}")
    actions = resolveProcesses(
        proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching
    )
    match = build_text_match(expected_output)

    def is_in(name: str) -> bool:
        for action in actions:
            text = text_of(proc_output[action], name)
            text = remove_ansi_escape_sequences(text) if strip_ansi_escape_sequences else text
            if match(text if output_filter is None else output_filter(text)) is not None:
                return True
        return False

    if is_in(stream):
        return
    other = "stdout" if stream == "stderr" else "stderr"
    hint = f"; it is in their {other}" if is_in(other) else ""
    raise AssertionError(
        f"Did not find '{expected_output}' in {stream} of any of the matching processes: "
        f"{', '.join(process_name(action) for action in actions)}{hint}"
    )


def assertDefaultStream() -> str:
    """Return the stream that `assertInStream` searches without its argument `stream`."""
    return "stderr"


def text_of(output: Iterable[ProcessIO], stream: str) -> str:
    """Return what was printed to `stdout`, `stderr`, or with an empty `stream` to both, as one text."""
    return b"".join(
        event.text
        for event in output
        if not stream or (event.from_stdout if stream == "stdout" else event.from_stderr)
    ).decode("utf-8", "replace")
