"""static_turtle_tf2_broadcaster: broadcast a static frame in the world: its name, x y z and roll pitch yaw."""

from __future__ import annotations

import math
import sys

from tfloom.common.terminal import report
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import spin
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster

USAGE = (
    "Invalid number of parameters. Usage: static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw"
)


def quaternion_from_euler(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of rotations about the fixed axes x, y and z, in this order [rad]."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


class StaticFramePublisher(Node):
    """Broadcasts world_from_frame once, to present and later subscriptions.

    Args:
        frame: The frame's name.
        numbers: x, y, z [m] and roll, pitch, yaw [rad].
    """

    def __init__(self, frame: str, numbers: list[float]) -> None:
        super().__init__("static_turtle_tf2_broadcaster")
        self.broadcaster = StaticTransformBroadcaster(self)
        world_from_frame = TransformStamped(child_frame_id=frame)
        world_from_frame.header.stamp = self.get_clock().now().to_msg()
        world_from_frame.header.frame_id = "world"
        translation, rotation = world_from_frame.transform.translation, world_from_frame.transform.rotation
        translation.x, translation.y, translation.z = numbers[:3]
        rotation.x, rotation.y, rotation.z, rotation.w = quaternion_from_euler(*numbers[3:])
        self.broadcaster.sendTransform(world_from_frame)


def main(args: list[str] | None = None) -> int:
    """Broadcast until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    words = remove_ros_args(args)
    if len(words) != 7:
        report(USAGE)
        return 1
    if words[0] == "world":
        report('Your static turtle name cannot be "world"')
        return 2
    try:
        numbers = [float(word) for word in words[1:]]
    except ValueError as error:
        report(f"{error}\n{USAGE}")
        return 1
    return run_program(args, lambda: spin(StaticFramePublisher(words[0], numbers)))
