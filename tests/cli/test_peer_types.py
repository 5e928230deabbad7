"""Commands on types whose definition another process alone has."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program

NODE = Path(__file__).with_name("a_node_with_own_types.py")


@pytest.fixture(scope="module")
def lab(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Start the node with its own types."""
    start_module_program("python", NODE).wait_for("ready")


@pytest.mark.usefixtures("lab")
@pytest.mark.parametrize("type_name", [(), ("lab_msgs/msg/Sample",), ("lab_msgs/Sample",)])
def test_echo_prints_messages_of_a_type_that_the_publisher_alone_has(type_name: tuple[str, ...]) -> None:
    answer = transcript.run_here("topic", "echo", "--once", "/samples", *type_name)
    assert answer.exit_code == 0
    assert answer.text == (
        "header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ''\nparts: []\nat:\n- 1.0\n- 2.0\n- 3.0\n---"
    )


@pytest.mark.usefixtures("lab")
@pytest.mark.parametrize(("verb", "line"), [("hz", "average rate: "), ("bw", "B/s from ")])
def test_rates_work_on_such_a_type(start_program: Callable[..., Program], verb: str, line: str) -> None:
    start_program("tfloom", "topic", verb, "/samples").wait_for(line)


@pytest.mark.usefixtures("lab")
def test_a_service_of_such_a_type_can_be_called() -> None:
    answer = transcript.run_here("service", "call", "/weigh", "lab_msgs/srv/Weigh", "{part: {count: 4}}")
    assert answer.exit_code == 0
    assert "lab_msgs.srv.Weigh_Response(grams=10.0)" in answer.text


@pytest.mark.usefixtures("lab")
def test_a_goal_of_such_a_type_can_be_sent() -> None:
    goal = "{parts: [{name: b}, {name: a, count: 3}]}"
    answer = transcript.run_here("action", "send_goal", "-f", "/sort", "lab_msgs/action/Sort", goal)
    assert answer.exit_code == 0
    assert "sorted:\n- name: a\n  count: 3\n- name: b\n" in answer.text
    assert "Feedback:\n    done: 1\n" in answer.text


@pytest.mark.usefixtures("lab")
def test_a_publisher_of_such_a_type_can_be_started(start_program: Callable[..., Program]) -> None:
    pub = start_program("tfloom", "topic", "pub", "/numbered", "lab_msgs/msg/Sample", "{at: [4, 5, 6]}")
    pub.wait_for("publishing #1: lab_msgs.msg.Sample(")


def test_a_description_that_does_not_have_the_announced_hash_is_refused(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    start_program("python", NODE, "lie").wait_for("ready")
    answer = transcript.run_here("topic", "echo", "--once", "/samples")
    assert answer.exit_code == 1
    assert "the description from /lab can't be used: " in answer.text
    assert "at:" not in answer.text
