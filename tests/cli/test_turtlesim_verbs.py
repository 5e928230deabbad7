"""The recorded commands about turtlesim, run with tfloom's turtlesim over DDS."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
import transcript

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
SPAWNED = "Spawning turtle [turtle1]"


@pytest.fixture(scope="module", autouse=True)
def turtlesim_to_ask(module_domain_id: int, start_module_program: Callable[..., object]) -> None:
    start_module_program(*TURTLESIM).wait_for(SPAWNED)


@pytest.fixture
def turtlesim(domain_id: int, start_program: Callable[..., object]) -> object:
    """Start another turtlesim, on a separate domain."""
    program = start_program(*TURTLESIM)
    program.wait_for(SPAWNED)
    return program


def test_node_info_of_turtlesim() -> None:
    recorded = transcript.golden("node_info")
    answer = transcript.run(*recorded.command)
    assert (answer.text, answer.exit_code) == (recorded.text.rstrip("\n"), recorded.exit_code)


def test_services_of_turtlesim() -> None:
    recorded = transcript.golden("service_list_t")
    its_own = [line for line in recorded.text.splitlines() if not re.match("/(static|talker)", line)]
    assert transcript.run(*recorded.command).text.splitlines() == its_own


def test_call_output_matches_the_recording(turtlesim: object) -> None:
    for name in ("service_call", "service_call_again", "service_call_empty"):
        recorded = transcript.golden(name)
        answer = transcript.run(*recorded.command)
        assert (transcript.without_waiting(answer.text), answer.exit_code) == (
            recorded.text.rstrip("\n"),
            recorded.exit_code,
        )
    turtlesim.wait_for("Spawning turtle [bob] at x=[2.000000], y=[3.000000], theta=[0.500000]")
    turtlesim.wait_for("A turtle named [bob] already exists")
    actions = transcript.golden("action_list_t")
    assert transcript.run(*actions.command) == actions


@pytest.mark.parametrize("name", ["action_info", "action_type"])
def test_action_of_turtlesim(name: str) -> None:
    recorded = transcript.golden(name)
    assert transcript.run(*recorded.command) == recorded


def masked(text: str) -> str:
    return transcript.mask(re.sub(r"ID: [0-9a-f]{32}", "ID: #", text))


def test_goal_turns_the_turtle(turtlesim: object) -> None:
    recorded = transcript.golden("action_send_goal")
    answer = transcript.run(*recorded.command)
    assert (masked(answer.text), answer.exit_code) == (masked(recorded.text), 0)
    turtlesim.wait_for("Rotation goal completed successfully")
    theta = float(
        transcript.run("topic", "echo", "--once", "--field", "theta", "/turtle1/pose").text.split()[0]
    )
    assert theta == pytest.approx(1.57, abs=0.02)


def test_ctrl_c_stops_the_turtle(turtlesim: object, start_program: Callable[..., object]) -> None:
    words = ("action", "send_goal", "-f", "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute")
    goal = start_program("tfloom", *words, "{theta: 3.0}")
    goal.wait_for("Feedback:")
    goal.signal(2)
    assert goal.wait() == 2
    assert goal.lines[-1] == "Goal canceled."
    velocity = ("topic", "echo", "--once", "--field", "angular_velocity", "/turtle1/pose")
    assert transcript.run(*velocity).text == "0.0\n---"
