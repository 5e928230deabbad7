"""Time that stands still until a test steps it."""

from __future__ import annotations

import pytest
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

from tfloom.testing.graph import RosGraph
from tfloom.testing.simulated_time import SimulatedTime


def seconds(node: Node) -> float:
    return node.get_clock().now().nanoseconds / 1e9


def test_all_nodes_show_the_same_time(ros_time: SimulatedTime, ros_graph: RosGraph, ros_node: Node) -> None:
    assert (ros_time.now_s, seconds(ros_node)) == (100.0, 100.0)
    ros_time.step(0.25)
    late = ros_graph.add(Node("late"))
    assert (seconds(ros_node), seconds(late)) == (100.25, 100.25)
    assert ros_time.now == late.get_clock().now()


def test_timers_run_once_a_period(ros_time: SimulatedTime, ros_node: Node) -> None:
    calls: list[float] = []
    ros_node.create_timer(0.1, lambda: calls.append(seconds(ros_node)))
    ros_time.step(0.09)
    assert calls == []
    ros_time.step(0.91)
    assert calls == pytest.approx([100.1, 100.2, 100.3, 100.4, 100.5, 100.6, 100.7, 100.8, 100.9, 101.0])
    ros_time.step(1.0, every_s=1.0)
    assert calls[10:] == [102.0], "a large step skips calls, as a slow simulator does"


def test_steps_add_up_exactly(ros_time: SimulatedTime) -> None:
    for _ in range(10):
        ros_time.step(0.1, every_s=0.03)
    assert ros_time.now.nanoseconds == 101_000_000_000


def test_time_can_jump_back(ros_time: SimulatedTime, ros_graph: RosGraph, ros_node: Node) -> None:
    buffer = Buffer(node=ros_node)
    listener = TransformListener(buffer, ros_node)
    ros_graph.broadcast("frame_id child_frame_id stamp\nmap base 100.0")
    assert buffer.can_transform("map", "base", Time())
    ros_time.set(50.0)
    assert seconds(ros_node) == 50.0
    with pytest.raises(TransformException):
        buffer.lookup_transform("map", "base", Time())
    listener.unregister()


def test_a_wait_by_the_nodes_clock_ends_with_a_step(ros_time: SimulatedTime, ros_node: Node) -> None:
    begin = ros_node.get_clock().now()
    ros_time.step(3600.0, every_s=60.0)
    assert ros_node.get_clock().now() - begin == Duration(seconds=3600)


@pytest.mark.parametrize("step", [(0,), (-1.0,), (float("nan"),), (1.0, 0.0), (1.0, -1.0)])
def test_steps_go_forward(ros_time: SimulatedTime, step: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match=r"time steps forward, .*set\(\) goes back"):
        ros_time.step(*step)


def test_time_0_is_none(ros_time: SimulatedTime) -> None:
    with pytest.raises(ValueError, match="greater than 0 s, not 0"):
        ros_time.set(0)


def test_without_it_nodes_show_the_wall_clock(ros_node: Node) -> None:
    assert seconds(ros_node) > 1e9


@pytest.mark.ros_wire("dds")
@pytest.mark.wire
def test_over_dds(ros_time: SimulatedTime, ros_node: Node) -> None:
    calls: list[float] = []
    ros_node.create_timer(0.1, lambda: calls.append(seconds(ros_node)))
    ros_time.step(0.5, every_s=0.1)
    assert calls == pytest.approx([100.1, 100.2, 100.3, 100.4, 100.5])
