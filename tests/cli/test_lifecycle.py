"""The verbs about lifecycle nodes, with a node in another process over DDS."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import transcript


@pytest.fixture(autouse=True)
def node(domain_id: int, start_program: Callable[..., object]) -> None:
    start_program("python", Path(__file__).with_name("a_lifecycle_node.py")).wait_for("ready")


def test_set_changes_the_state_of_a_node() -> None:
    assert transcript.run_here("lifecycle", "nodes").text == "/a_node"
    assert transcript.run_here("lifecycle", "nodes", "-c").text == "1"
    assert transcript.run_here("lifecycle", "get", "/a_node").text == "unconfigured [1]"
    configure = "- configure [1]\n\tStart: unconfigured\n\tGoal: inactive"
    assert transcript.run_here("lifecycle", "list", "/a_node").text == configure
    assert transcript.run_here("lifecycle", "set", "/a_node", "configure").text == "Transitioning successful"
    assert transcript.run_here("lifecycle", "get").text == "/a_node: inactive [2]"
    assert transcript.run_here("lifecycle", "list", "-a", "/a_node").text.startswith(
        configure + "\n- cleanup [2]\n"
    )
    assert transcript.run_here("lifecycle", "set", "/a_node", "2").exit_code == 0


def test_invalid_arguments_give_an_error_message() -> None:
    unknown = transcript.run_here("lifecycle", "set", "/a_node", "activate")
    assert unknown.exit_code == 1
    assert unknown.text == "Unknown transition requested, available ones are:\n- configure [1]"
    nobody = transcript.run_here("lifecycle", "get", "/a_nod")
    assert (nobody.exit_code, nobody.text) == (1, "Node not found\ndid you mean /a_node?")
