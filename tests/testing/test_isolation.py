"""What a test changes in the process is as before at its end."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node
from std_msgs.msg import String

from tfloom.testing.isolation import isolated


def state() -> tuple[object, ...]:
    return (
        rclpy.get_default_context(),
        {name: value for name, value in os.environ.items() if name.startswith(("ROS_", "RMW_"))},
        signal.getsignal(signal.SIGINT),
        signal.getsignal(signal.SIGTERM),
    )


def test_everything_is_restored_also_after_an_error(tmp_path: Path) -> None:
    before = state()
    made: list[Context] = []

    def fail_in_a_block() -> None:
        with isolated("local", tmp_path):
            rclpy.init(args=[])
            own = Context()
            own.init(args=[])
            made.extend([rclpy.get_default_context(), own])
            assert signal.getsignal(signal.SIGINT) is not before[2]
            Node("left")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail_in_a_block()
    assert state() == before
    assert [context.ok() for context in made] == [False, False]


@pytest.mark.parametrize("is_before_init", [True, False])
def test_handlers_of_a_program_are_taken_away(tmp_path: Path, is_before_init: bool) -> None:
    before = state()
    with isolated("local", tmp_path):
        if not is_before_init:
            rclpy.init(args=[])
        signal.signal(signal.SIGINT, lambda *_: None)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        if is_before_init:
            rclpy.init(args=[])
    assert state() == before


def test_contexts_from_before_go_on(tmp_path: Path) -> None:
    context = Context()
    context.init(args=[])
    with isolated("local", tmp_path):
        rclpy.init(args=[])
    assert context.ok()
    context.shutdown()


def test_a_default_context_can_be_initialised_in_each_block(tmp_path: Path) -> None:
    for _ in range(3):
        with isolated("local", tmp_path), rclpy.init(args=[]) as block:
            node = Node("same_name")
            assert node.get_node_names() == ["same_name"], "nobody of the block before"
            assert block.context is node.context


def test_a_main_that_initialises(ros_domain: int) -> None:
    """A program's own `main` runs as it is."""

    def main() -> str:
        rclpy.init(args=[])
        node = rclpy.create_node("program")
        assert node.context.get_domain_id() == ros_domain
        name = node.get_fully_qualified_name()
        rclpy.shutdown()
        return name

    assert [main(), main()] == ["/program", "/program"]


def test_log_files_are_in_a_folder_of_the_tests(ros_context: Context, ros_node: Node) -> None:
    assert ros_context.ok()
    ros_node.get_logger().warning("for the file")
    assert "ros_log" in os.environ["ROS_LOG_DIR"]


@pytest.mark.parametrize("attempt", [1, 2])
def test_graphs_of_tests_are_apart(ros_node: Node, attempt: int) -> None:
    ros_node.create_publisher(String, f"topic_{attempt}", 1)
    topics = {name for name, _ in ros_node.get_topic_names_and_types()}
    assert f"/topic_{attempt}" in topics
    assert f"/topic_{3 - attempt}" not in topics


def test_the_default_context_is_the_tests(ros_context: Context, ros_node: Node) -> None:
    assert ros_node.context is ros_context is rclpy.get_default_context()
    assert ros_node.get_fully_qualified_name() == "/test_node"
    with pytest.raises(RuntimeError, match="must only be called once"):
        rclpy.init()
