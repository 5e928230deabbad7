"""The robot's programs as processes over DDS, against the reference's output."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.cli.transcript import run_here
from tests.recorded_outputs import recorded_output

from tfloom.node.context.context import Context
from tfloom.node.node import Node

GOLDEN = Path(__file__).parents[1] / "golden"
ARM = GOLDEN / "arm.urdf"
RSP = ("tfloom", "run", "robot_state_publisher", "robot_state_publisher")
STATE = "{header: auto, name: [shoulder, rail, roll], position: [0.3, 0.1, 1.0]}"


def golden(name: str) -> list[str]:
    """Return the reference's output, without the command, the signal's line, and the last and empty ones."""
    lines = recorded_output(name).splitlines()[1:-1]
    return "\n".join(line for line in lines if "signal_handler" not in line).rstrip("\n").splitlines()


def masked(lines: list[str]) -> list[str]:
    return [re.sub(r"\[\d+\.\d+\]", "[stamp]", line) for line in lines]


@pytest.fixture(scope="module")
def publisher(module_domain_id: int, start_module_program: Callable[..., Any]) -> Any:
    """Return the program with the recorded arm, from the deprecated argument."""
    program = start_module_program(*RSP, ARM)
    program.wait_for("Robot initialized")
    return program


@pytest.fixture
def ask(publisher: Any) -> Callable[..., list[str]]:
    """Return a function that runs a verb, and returns its lines."""

    def run(*words: str) -> list[str]:
        answer = run_here(*words)
        assert answer.exit_code == 0, answer.text
        return answer.text.splitlines()

    return run


def test_the_log_with_a_file_as_argument(publisher: Any) -> None:
    assert masked(publisher.lines)[:2] == masked(golden("rsp_file_argument"))
    assert masked(publisher.lines)[1:2] == masked(golden("rsp_log"))


def test_what_it_shows_matches_the_reference(ask: Callable[..., list[str]]) -> None:
    node = "/robot_state_publisher"
    assert ask("node", "info", node, "--no-daemon") == golden("rsp_node_info")
    assert ask("param", "dump", node, "--no-daemon") == golden("rsp_params")
    names = ("frame_prefix", "publish_frequency", "ignore_timestamp", "robot_description")
    assert ask("param", "describe", node, *names, "--no-daemon") == golden("rsp_describe")


def test_the_endpoints_have_the_references_policies(
    publisher: Any, module_domain_id: int, wait_until: Callable[..., None]
) -> None:
    wanted = {
        "/joint_states": ("BEST_EFFORT", "VOLATILE"),
        "/robot_description": ("RELIABLE", "TRANSIENT_LOCAL"),
        "/tf": ("RELIABLE", "VOLATILE"),
        "/tf_static": ("RELIABLE", "TRANSIENT_LOCAL"),
    }
    context = Context()
    context.init(args=[], domain_id=module_domain_id)
    node = Node("onlooker", context=context)

    def policies(topic: str) -> list[tuple[str, str]]:
        endpoints = [*node.get_publishers_info_by_topic(topic), *node.get_subscriptions_info_by_topic(topic)]
        return [
            (endpoint.qos_profile.reliability.name, endpoint.qos_profile.durability.name)
            for endpoint in endpoints
        ]

    try:
        wait_until(lambda: all(policies(topic) for topic in wanted))
        assert {topic: policies(topic) for topic in wanted} == {topic: [qos] for topic, qos in wanted.items()}
    finally:
        context.destroy()


def test_the_description_and_the_fixed_joints_reach_late_subscriptions(ask: Callable[..., list[str]]) -> None:
    lines = ask("topic", "echo", "--once", "--field", "data", "/robot_description", "--no-daemon")
    assert lines[:5] == golden("rsp_description")[:5]
    static = ask("topic", "echo", "--once", "/tf_static", "--no-daemon")
    assert "    frame_id: spin" in static
    assert "      w: 0.707106790659974" in static


def test_states_become_transforms(publisher: Any, start_module_program: Callable[..., Any]) -> None:
    echo = start_module_program("tfloom", "run", "tf2_ros", "tf2_echo", "base", "tool")
    state = "sensor_msgs/msg/JointState"
    sender = start_module_program("tfloom", "topic", "pub", "-r", "20", "/joint_states", state, STATE)
    echo.wait_for("- Translation: [0.819, 0.000, 0.127]")
    for program in (sender, echo):
        program.signal(signal.SIGINT)
        program.wait()


def test_parameters_are_refused_and_set_as_in_the_reference(
    ask: Callable[..., list[str]], deviations: dict[str, dict[str, str]]
) -> None:
    node = "/robot_state_publisher"
    assert "param-exit-code" in deviations
    for words, name in (
        (("robot_description", "<robot"), "rsp_set_description_bad"),
        (("publish_frequency", "--", "-1.0"), "rsp_set_frequency_bad"),
    ):
        answer = run_here("param", "set", node, *words)
        assert (answer.exit_code, answer.text.splitlines()) == (1, golden(name))
    assert ask("param", "set", node, "frame_prefix", "r1/") == golden("rsp_set_prefix")
    static = ask("topic", "echo", "--once", "/tf_static", "--no-daemon")
    assert "  child_frame_id: r1/tool" in static


def test_faulty_descriptions_end_it(
    start_program: Callable[..., Any], domain_id: int, deviations: dict[str, dict[str, str]]
) -> None:
    assert "rsp-abort" in deviations
    program = start_program(*RSP)
    assert program.wait() == 1
    assert masked(program.lines)[0] == masked(golden("rsp_no_description"))[0]
    program = start_program(*RSP, "--ros-args", "-p", "robot_description:=<robot")
    assert program.wait() == 1
    reason = golden("rsp_bad_description")[-2].removeprefix("  what():  ")
    assert reason == "Unable to initialize urdf::model from robot description"
    line = f"[FATAL] [stamp] [robot_state_publisher]: {reason}: line 1: not well-formed XML: unclosed token at column 1"
    assert masked(program.lines)[0] == line
