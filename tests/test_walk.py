"""From a key press to a printed line: every room in one process on the in-process wire, without a sleep."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Callable, Iterator

import pytest

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.client_library import init, try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2.buffer import LATEST
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.tf2_tools.text import transform_text
from tfloom.turtlesim.node import TurtlesimNode
from tfloom.turtlesim.teleop_key import TeleopTurtle

TIMEOUT_S = 20.0


class Broadcaster(Node):
    """Broadcasts each pose of turtle1 as a transform from `world`."""

    def __init__(self) -> None:
        super().__init__("broadcaster")
        self.poses: list[Pose] = []
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, "turtle1/pose", self.on_pose, 10)

    def on_pose(self, pose: Pose) -> None:
        self.poses.append(pose)
        world_from_turtle1 = TransformStamped()
        world_from_turtle1.header.stamp = self.get_clock().now().to_msg()
        world_from_turtle1.header.frame_id = "world"
        world_from_turtle1.child_frame_id = "turtle1"
        world_from_turtle1.transform.translation.x = pose.x
        world_from_turtle1.transform.translation.y = pose.y
        world_from_turtle1.transform.rotation.z = math.sin(pose.theta / 2)
        world_from_turtle1.transform.rotation.w = math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(world_from_turtle1)


@pytest.fixture
def executor(monkeypatch: pytest.MonkeyPatch) -> Iterator[SingleThreadedExecutor]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    init(args=[])
    with SingleThreadedExecutor() as executor:
        yield executor
        for node in executor.get_nodes():
            node.destroy_node()
    try_shutdown()


def test_key_press_leads_to_a_printed_transform(executor: SingleThreadedExecutor) -> None:
    turtlesim, teleop, broadcaster, echo = TurtlesimNode(), TeleopTurtle(), Broadcaster(), Node("echo")
    buffer = Buffer()
    listener = TransformListener(buffer, echo)
    for node in (turtlesim, teleop, broadcaster, echo):
        executor.add_node(node)

    def spin_until(condition: Callable[[], object]) -> None:
        end = time.monotonic() + TIMEOUT_S
        while not condition():
            assert time.monotonic() < end, "the walk has stopped on its way"
            executor.spin_once(timeout_sec=1.0)

    def seen() -> tuple[float, float]:
        transform = buffer.lookup_transform("world", "turtle1", Time()).transform
        return transform.translation.x, transform.translation.y

    spin_until(lambda: broadcaster.poses)
    start = broadcaster.poses[-1]
    assert (start.x, start.y) == pytest.approx((5.544445, 5.544445))
    assert seen() == (start.x, start.y)

    teleop.press("up")
    spin_until(lambda: broadcaster.poses[-1].x > start.x + 0.1)
    ahead = broadcaster.poses[-1]
    assert ahead.linear_velocity == 2.0
    assert seen() == (ahead.x, ahead.y)

    teleop.press("left")
    spin_until(lambda: broadcaster.poses[-1].angular_velocity == 2.0)
    spin_until(lambda: broadcaster.poses[-1].theta > 0.1)

    pose = broadcaster.poses[-1]
    stamp_ns, translation, rotation = printed(buffer)
    text = transform_text(stamp_ns, translation, rotation)
    lines = text.replace("-0.000", "0.000").splitlines()  # the sign of a zero angle is arbitrary
    assert re.fullmatch(r"At time \d{10}\.\d{9}", lines[0])
    assert lines[1] == f"- Translation: [{pose.x:.3f}, {pose.y:.3f}, 0.000]"
    assert lines[4] == f"- Rotation: in RPY (degree) [0.000, 0.000, {math.degrees(pose.theta):.3f}]"
    assert lines[6].split() == [
        f"{cell:.3f}" for cell in (math.cos(pose.theta), -math.sin(pose.theta), 0.0, pose.x)
    ]
    listener.unregister()


def printed(buffer: Buffer) -> tuple[int, tuple[float, ...], tuple[float, ...]]:
    """Return the values that tf2_echo prints: stamp [ns], translation and rotation of the newest transform."""
    newest = buffer.lookup("world", "turtle1", LATEST)
    return newest.stamp_ns, tuple(newest.translation), tuple(newest.rotation_xyzw)
