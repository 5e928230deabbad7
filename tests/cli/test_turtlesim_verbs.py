"""The recorded commands about turtlesim, run with tfloom's turtlesim over DDS."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
import transcript
from tests.conftest import Program

pytestmark = pytest.mark.usefixtures("turtlesim")


def test_node_info_of_turtlesim() -> None:
    transcript.check("node_info", "\n")


def test_services_of_turtlesim() -> None:
    recorded = transcript.golden("service_list_t")
    its_own = [line for line in recorded.text.splitlines() if not re.match("/(static|talker)", line)]
    assert transcript.run_here(*recorded.command).text.splitlines() == its_own


def test_call_output_matches_the_recording(turtlesim_to_change: Program) -> None:
    for name in ("service_call", "service_call_again", "service_call_empty"):
        transcript.check_call(name)
    turtlesim_to_change.wait_for("Spawning turtle [bob] at x=[2.000000], y=[3.000000], theta=[0.500000]")
    turtlesim_to_change.wait_for("A turtle named [bob] already exists")
    transcript.check("action_list_t")


@pytest.mark.parametrize("name", ["action_info", "action_type"])
def test_action_of_turtlesim(name: str) -> None:
    transcript.check(name)


def test_goal_turns_the_turtle(turtlesim_to_change: Program) -> None:
    recorded = transcript.golden("action_send_goal")
    answer = transcript.run_here(*recorded.command)
    masked = transcript.mask_goal
    assert (masked(answer.text), answer.exit_code) == (masked(recorded.text), 0)
    turtlesim_to_change.wait_for("Rotation goal completed successfully")
    pose = transcript.run_here("topic", "echo", "--once", "--field", "theta", "/turtle1/pose")
    assert float(pose.text.split()[0]) == pytest.approx(1.57, abs=0.02)


@pytest.mark.usefixtures("turtlesim_to_change")
def test_ctrl_c_stops_the_turtle(start_program: Callable[..., object]) -> None:
    words = ("action", "send_goal", "-f", "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute")
    goal = start_program("tfloom", *words, "{theta: 3.0}")
    goal.wait_for("Feedback:")
    goal.signal(2)
    assert goal.wait() == 2
    assert goal.lines[-1] == "Goal canceled."
    velocity = ("topic", "echo", "--once", "--field", "angular_velocity", "/turtle1/pose")
    assert transcript.run_here(*velocity).text == "0.0\n---"
