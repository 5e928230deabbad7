"""The verbs about actions, with a server in another process over DDS."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program, wait_until

SEND = ("action", "send_goal", "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute")


@pytest.fixture(scope="module", autouse=True)
def server(module_domain_id: int, start_module_program: Callable[..., object]) -> object:
    program = start_module_program("python", Path(__file__).with_name("an_action_server.py"))
    program.wait_for("ready")
    return program


@pytest.mark.parametrize("name", ["action_info", "action_type"])
def test_answers_match_the_recording(name: str) -> None:
    transcript.check(name)


def test_list_prints_all() -> None:
    recorded = transcript.golden("action_list_t")
    line = recorded.text.splitlines()[-1]
    assert transcript.run_here(*recorded.command).text == line
    assert transcript.run_here("action", "list").text == line.split()[0]
    assert transcript.run_here("action", "list", "-c").text == "1"
    assert json.loads(transcript.run_here("action", "list", "--json").text)[0]["types"] == [
        "turtlesim/action/RotateAbsolute"
    ]


def test_goal_output_matches_the_recording() -> None:
    recorded = transcript.golden("action_send_goal")
    answer = transcript.run_here(*recorded.command)
    assert (transcript.mask_goal(answer.text), answer.exit_code) == (
        transcript.mask_goal(recorded.text),
        recorded.exit_code,
    )
    assert "    delta: -2.0\n" in answer.text


def test_feedback_output_matches_the_recording() -> None:
    recorded = transcript.golden("action_send_goal_feedback")
    words = recorded.command[: recorded.command.index("|")]
    answer = transcript.run_here(*words)
    assert re.findall(r"^Feedback:\n    remaining: (.*)\n$", answer.text, re.MULTILINE) == ["-0.5", "-0.25"]
    # The reference's blocks, in any order and number.
    assert set(transcript.mask_goal(answer.text).split("\n\n")) == set(
        transcript.mask_goal(recorded.text).split("\n\n")
    )


def test_ctrl_c_cancels_the_goal(server: object, start_program: Callable[..., object]) -> None:
    goal = start_program("tfloom", *SEND, "{theta: -1.0}")
    goal.wait_for("Goal accepted with ID")
    goal.signal(2)
    server.wait_for("canceling")
    assert goal.wait() == 2
    assert goal.lines[-2:] == ["Canceling goal...", "Goal canceled."]


def test_rejected_goal_gives_exit_code_1(deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-goal-exit-code" in deviations
    answer = transcript.run_here(*SEND, "{theta: 0.0}")
    assert (answer.text.splitlines()[-1], answer.exit_code) == ("Goal was rejected.", 1)


def test_invalid_arguments_give_an_error_message() -> None:
    near = transcript.run_here("action", "type", "/turtle1/rotate")
    assert near.text.startswith("Unknown action '/turtle1/rotate'\ndid you mean /turtle1/rotate_absolute?")
    wrong = transcript.run_here("action", "send_goal", "/turtle1/rotate_absolute", "turtlesim/action/Rotate")
    assert wrong.text.startswith("The passed action type is invalid\n")
    assert transcript.run_here(*SEND, "{angle: 1}").text.endswith("RotateAbsolute_Goal has: theta")


def test_find_prints_the_actions_of_a_type() -> None:
    words = ("action", "find", "turtlesim/action/RotateAbsolute")
    assert transcript.run_here(*words).text == "/turtle1/rotate_absolute"
    assert transcript.run_here(*words, "-c").text == "1"
    assert transcript.run_here("action", "find", "example_interfaces/action/Fibonacci").text == ""
    near = transcript.run_here("action", "find", "turtlesim/action/Rotate").text
    assert near.startswith("there is no action type 'turtlesim/action/Rotate'\ndid you mean")


def test_echo_prints_what_each_interface_carries(start_program: Callable[..., Program]) -> None:
    echo = start_program("tfloom", "action", "echo", "/turtle1/rotate_absolute")
    lines = start_program("tfloom", "action", "echo", "--json", "--interfaces", "FEEDBACK_TOPIC", SEND[2])
    echo.wait_for("no publisher yet of CANCEL_SERVICE, RESULT_SERVICE, STATUS_TOPIC (services are published")
    assert transcript.run_here(*SEND, "{theta: 1.5}").exit_code == 0
    echo.wait_for("remaining: -0.25")
    echo.wait_for("event_type: RESPONSE_SENT")
    blocks = [block.split("\n") for block in echo.output.split("---\n")]
    goals = [block for block in blocks if "interface: GOAL_SERVICE" in block]
    events = [line.split()[-1] for block in goals for line in block if "event_type: " in line]
    assert events == ["REQUEST_RECEIVED", "RESPONSE_SENT"]
    assert any(line.strip() == "theta: 1.5" for line in goals[0])
    feedback = [block for block in blocks if "interface: FEEDBACK_TOPIC" in block]
    remaining = [line.strip() for block in feedback for line in block if "remaining" in line]
    assert remaining == ["remaining: -0.5", "remaining: -0.25"]
    lines.wait_for("-0.25")
    first, second = (json.loads(line) for line in lines.lines if line.startswith("{"))
    assert (first["interface"], first["message"]["feedback"]) == ("FEEDBACK_TOPIC", {"remaining": -0.5})
    assert second["message"]["feedback"] == {"remaining": -0.25}


def test_echo_refuses_what_is_not_there() -> None:
    unknown = transcript.run_here("action", "echo", "/turtle1/rotate")
    assert unknown.exit_code == 1
    assert unknown.text.startswith(
        "Could not determine the type of action '/turtle1/rotate': it isn't on the graph"
    )
    wrong = transcript.run_here("action", "echo", "--interfaces", "GOAL|FEEDBACK_TOPIC", SEND[2])
    assert wrong.exit_code == 2
    assert "'GOAL' is not one of GOAL_SERVICE, CANCEL_SERVICE" in wrong.text


LISTS = """\
Waiting for an action server to become available...
Sending goal:
     order: 2

Goal accepted with ID: #

Feedback:
    sequence:
- #

Feedback:
    sequence:
- #
- #

Result:
    sequence:
- #
- #
- #

Goal finished with status: SUCCEEDED"""


def test_the_acceptance_comes_first_and_lists_as_the_reference_prints_them(
    domain_id: int, start_program: Callable[..., object], deviations: dict[str, dict[str, str]]
) -> None:
    assert "cli-goal-accepted-first" in deviations
    start_program("python", Path(__file__).with_name("a_counting_server.py")).wait_for("ready")
    words = ("action", "send_goal", "-f", "/count", "example_interfaces/action/Fibonacci", "{order: 2}")
    answer = transcript.run_here(*words)
    assert transcript.mask_goal(answer.text).replace("order: #", "order: 2") == LISTS
    assert answer.exit_code == 0


def test_a_goal_that_takes_too_long_is_cancelled(server: Program) -> None:
    answer = transcript.run_here(*SEND, "{theta: -1.0}", "-t", "0.5")
    assert answer.exit_code == 1
    said = "Timed out waiting for the result after 0.5 seconds. Canceling goal...\nGoal canceled."
    assert answer.text.endswith(said), answer.text
    before = server.output.count("canceling")
    answer = transcript.run_here(*SEND, "{theta: 7.0}", "--timeout", "0.3")
    assert answer.exit_code == 1
    assert answer.text.endswith("Timed out waiting for goal acceptance after 0.3 seconds.")
    wait_until(lambda: server.output.count("canceling") > before)
    assert transcript.run_here(*SEND, "{theta: 1.0}", "-t", "30").exit_code == 0
