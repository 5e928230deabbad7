"""Replay of a session recorded from the reference: the commands' output and turtlesim's log."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

GOLDEN = Path(__file__).parents[1] / "golden" / "cli"
WAITING = "waiting for service to become available..."
# The start heading from which the turtle turns by the recorded angle.
TELEPORT = (
    *("tfloom", "service", "call", "/turtle1/teleport_absolute", "turtlesim/srv/TeleportAbsolute"),
    "{x: 5.0, y: 5.0, theta: -0.46}",
)


def recorded(name: str) -> tuple[list[str], list[str], int]:
    """A command's words after `ros2`, the lines that it printed, and its exit code."""
    command, *lines, end = (GOLDEN / f"{name}.txt").read_text().splitlines()
    _, *words = (word for word in shlex.split(command.removeprefix("$ ")) if word != "--no-daemon")
    return words, lines, int(end.removeprefix("[exit ").removesuffix("]"))


def masked(lines: list[str]) -> list[str]:
    """Lines without stamps and goal ids."""
    return [re.sub(r"\[\d+\.\d+\]|with ID: [0-9a-f]{32}", "masked", line) for line in lines]


@pytest.fixture
def turtlesim(domain_id: int, start_program: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    program = start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
    program.wait_for("Spawning turtle [turtle1]")
    return program


@pytest.fixture
def replay(turtlesim: Any, start_program: Callable[..., Any]) -> Callable[[str], None]:
    def replay(name: str) -> None:
        words, lines, code = recorded(name)
        command = start_program("tfloom", *words)
        assert command.wait() == code
        # The message of a call that waits longer than a second, as it may on a busy machine.
        waited = command.lines[:1] == [WAITING] != lines[:1]
        assert masked(command.lines[waited:]) == masked(lines)

    return replay


def test_services_actions_and_parameters_match_the_recording(
    turtlesim: Any, replay: Callable[[str], None], start_program: Callable[..., Any]
) -> None:
    for name in ("service_call", "service_call_again", "service_call_empty", "action_list_t", "action_info"):
        replay(name)
    for _ in range(2):
        assert start_program(*TELEPORT).wait() == 0
        replay("action_send_goal")
    _, log, _ = recorded("turtlesim_log")
    assert masked(turtlesim.lines) == masked([line for line in log if line.startswith("[")])
    for name in ("param_set", "param_set_bad", "param_set_range", "param_describe"):
        replay(name)
