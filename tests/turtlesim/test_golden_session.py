"""Replay of a session recorded from the reference: the commands' output and turtlesim's log."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from tests.cli.transcript import golden, run_here, without_waiting
from tests.recorded_outputs import recorded_output

# The start heading from which the turtle turns by the recorded angle.
TELEPORT = (
    *("service", "call", "/turtle1/teleport_absolute", "turtlesim/srv/TeleportAbsolute"),
    "{x: 5.0, y: 5.0, theta: -0.46}",
)


def masked(text: str) -> str:
    """Return a text without stamps and goal ids."""
    return re.sub(r"\[\d+\.\d+\]|with ID: [0-9a-f]{32}", "masked", text)


@pytest.fixture
def turtlesim(domain_id: int, start_program: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    program = start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
    program.wait_for("Spawning turtle [turtle1]")
    return program


def replay(name: str, exit_code: int | None = None) -> None:
    """Run a recorded command; its exit code is the recorded one, where a row of the deviations says no other."""
    recorded = golden(name)
    answer = run_here(*recorded.command)
    assert answer.exit_code == (recorded.exit_code if exit_code is None else exit_code)
    assert masked(without_waiting(answer.text)) == masked(recorded.text.rstrip("\n"))


def test_services_actions_and_parameters_match_the_recording(
    turtlesim: Any, deviations: dict[str, dict[str, str]]
) -> None:
    for name in ("service_call", "service_call_again", "service_call_empty", "action_list_t", "action_info"):
        replay(name)
    for _ in range(2):
        assert run_here(*TELEPORT).exit_code == 0
        replay("action_send_goal")
    _, *lines, _ = recorded_output("turtlesim_log").splitlines()
    log = [line for line in lines if line.startswith("[")]
    assert masked(turtlesim.output) == masked("\n".join(log))
    assert "param-exit-code" in deviations
    replay("param_set")
    for refused in ("param_set_bad", "param_set_range"):
        replay(refused, exit_code=1)
    replay("param_describe")
