"""The session that was recorded from the reference, played again: the commands' output and turtlesim's log."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.wire
GOLDEN = Path(__file__).parents[1] / "golden" / "cli"
COMMANDS = ("service_call", "service_call_again", "service_call_empty")


def recorded(name: str) -> tuple[list[str], str, int]:
    """A command, what it printed and its exit code."""
    command, *lines, end = (GOLDEN / f"{name}.txt").read_text().splitlines()
    words = [word for word in shlex.split(command.removeprefix("$ ")) if word != "--no-daemon"]
    return words, "\n".join(lines), int(end.removeprefix("[exit ").removesuffix("]"))


def masked(line: str) -> str:
    return re.sub(r"\[\d+\.\d+\]", "[stamp]", line)


def test_services(domain_id: int, start_program: Callable[..., Any]) -> None:
    turtlesim = start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
    turtlesim.wait_for("Spawning turtle [turtle1]")
    for name in COMMANDS:
        (_, *words), text, code = recorded(name)
        command = start_program("tfloom", *words)
        assert command.wait() == code
        assert command.output == text
    _, log, _ = recorded("turtlesim_log")
    expected = [masked(line) for line in log.splitlines() if line.startswith("[") and "Rotation" not in line]
    turtlesim.wait_for("Clearing turtlesim.")
    assert [masked(line) for line in turtlesim.lines] == expected
