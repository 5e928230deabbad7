"""dynamic_frame_tf2_broadcaster: broadcast a frame that circles turtle1 at ten metres, half a turn a second."""

from __future__ import annotations

import math

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

PERIOD_S = 0.1
RADIUS_M = 10.0


class DynamicFrameBroadcaster(Node):
    """Broadcasts turtle1_from_carrot1 ten times a second, by the whole seconds of the clock."""

    def __init__(self) -> None:
        super().__init__("dynamic_frame_tf2_broadcaster")
        self.broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(PERIOD_S, self.on_timer)

    def on_timer(self) -> None:
        """Broadcast the position of carrot1, with the present time."""
        now = self.get_clock().now()
        seconds, _ = now.seconds_nanoseconds()
        angle = seconds * math.pi
        turtle_from_carrot = TransformStamped(child_frame_id="carrot1")
        turtle_from_carrot.header.stamp = now.to_msg()
        turtle_from_carrot.header.frame_id = "turtle1"
        turtle_from_carrot.transform.translation.x = RADIUS_M * math.sin(angle)
        turtle_from_carrot.transform.translation.y = RADIUS_M * math.cos(angle)
        self.broadcaster.sendTransform(turtle_from_carrot)


def main(args: list[str] | None = None) -> int:
    """Broadcast until stopped; return the exit code."""
    expect_no_arguments(
        "dynamic_frame_tf2_broadcaster",
        "Broadcast the frame carrot1, which circles turtle1 at ten metres, half a turn a second.",
        args,
    )
    return run_program(args, lambda: spin(DynamicFrameBroadcaster()))
