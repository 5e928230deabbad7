"""Recorded output of the reference's commands, and tfloom's to compare with it."""

from __future__ import annotations

import io
import itertools
import re
import shlex
import subprocess
import sys
from collections.abc import Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import pytest
from tests.conftest import python_with
from tests.recorded_outputs import recorded_output

from tfloom.cli.main import main
from tfloom.cli.shared.graph import MISSING
from tfloom.launch.actions import executable
from tfloom.launch.logs import logging as launch_logging

PROGRAM = Path(sys.executable).with_name("tfloom")
NO_CONSTANTS: Mapping[str, float] = MappingProxyType({})


class Transcript(NamedTuple):
    """A command line, all that it printed, and its exit code."""

    command: list[str]
    text: str
    exit_code: int


def golden(name: str) -> Transcript:
    """Return a recorded transcript by its heading."""
    first, *lines = recorded_output(name).splitlines()
    assert first.startswith("$ ros2 ")
    exit_code = re.fullmatch(r"\[exit (\d+)\]", lines.pop())
    assert exit_code
    command = [word for word in shlex.split(first.removeprefix("$ ros2 ")) if word != "--no-daemon"]
    return Transcript(command, "\n".join(lines), int(exit_code[1]))


def python_words(*words: str, constants: Mapping[str, float] = NO_CONSTANTS) -> list[str | Path]:
    """Return the Python command line that runs the command under ros2's name; see `python_with`."""
    return python_with(constants, "from tfloom.cli.main import main; sys.exit(main(prog='ros2'))", *words)


def run(
    *words: str,
    env: Mapping[str, str] | None = None,
    timeout_s: float = 60.0,
    constants: Mapping[str, float] = NO_CONSTANTS,
    cwd: Path | None = None,
) -> Transcript:
    """Run the command under ros2's name and return its output on both streams together.

    `constants` as for `python_with`.
    """
    result = subprocess.run(
        [sys.executable, *python_words(*words, constants=constants)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        stdin=subprocess.DEVNULL,
        text=True,
        check=False,
        env=env,
        timeout=timeout_s,
        cwd=cwd,
    )
    return Transcript(list(words), result.stdout.rstrip("\n"), result.returncode)


def run_here(*words: str) -> Transcript:
    """Run the command as `run` does, but in this process, because the start of a Python takes most of a verb's time."""
    output = Output()
    exit_code = exit_code_of(words, output, output)
    return Transcript(list(words), output.text.rstrip("\n"), exit_code)


def launch_here(*words: str) -> Transcript:
    """Run `launch …` as `run_here` does, as if it were the first launch of this process."""
    launch_logging.reset()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(executable, "_process_numbers", itertools.count(1))
        try:
            return run_here("launch", *words)
        finally:
            launch_logging.reset()


class Output(io.TextIOWrapper):
    """A stream of this process."""

    def __init__(self) -> None:
        super().__init__(io.BytesIO(), "utf-8")

    @property
    def text(self) -> str:
        """What was written so far."""
        self.flush()
        return self.buffer.getvalue().decode()


def exit_code_of(words: Sequence[str], out: Output, err: Output) -> int:
    """Run the command under ros2's name in this process; return its exit code."""
    with redirect_stdout(out), redirect_stderr(err):
        try:
            return main(words, prog="ros2")
        except SystemExit as end:
            return int(end.code or 0)


def check(name: str, without_end: str = "") -> None:
    """Check that a recorded command prints here what it printed there, and ends with the same exit code.

    Args:
        name: Of the recording.
        without_end: Characters at the end of the recorded text that don't count.
    """
    recorded = golden(name)
    assert run_here(*recorded.command) == recorded._replace(text=recorded.text.rstrip(without_end))


def check_call(name: str) -> None:
    """Check a recorded `service call` as `check` does, but for a message about a wait and empty lines at the end."""
    recorded, answer = golden(name), run_here(*golden(name).command)
    text = without_waiting(answer.text)
    assert answer._replace(text=text) == recorded._replace(text=recorded.text.rstrip("\n"))


def without_waiting(text: str) -> str:
    """Remove what is printed on a busy machine: that a call waits longer, and that nodes may be missing."""
    return text.removeprefix("waiting for service to become available...\n").removeprefix(f"{MISSING}\n")


def mask_goal(text: str) -> str:
    """Replace the id of a goal, and each number, with `#`."""
    return mask(re.sub(r"ID: [0-9a-f]{32}", "ID: #", text))


def mask(text: str) -> str:
    """Replace each number with `#`."""
    return re.sub(r"-?\d+(\.\d+)?(e[-+]?\d+)?", "#", text)
