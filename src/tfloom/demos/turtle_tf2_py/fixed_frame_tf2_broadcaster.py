"""fixed_frame_tf2_broadcaster: broadcast a frame two metres to the left of turtle1."""

from __future__ import annotations

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

PERIOD_S = 0.1


class FixedFrameBroadcaster(Node):
    """Broadcasts a constant turtle1_from_carrot1 ten times a second."""

    def __init__(self) -> None:
        super().__init__("fixed_frame_tf2_broadcaster")
        self.broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(PERIOD_S, self.on_timer)

    def on_timer(self) -> None:
        """Broadcast the position of carrot1, with the present time."""
        turtle_from_carrot = TransformStamped(child_frame_id="carrot1")
        turtle_from_carrot.header.stamp = self.get_clock().now().to_msg()
        turtle_from_carrot.header.frame_id = "turtle1"
        turtle_from_carrot.transform.translation.y = 2.0
        self.broadcaster.sendTransform(turtle_from_carrot)


def main(args: list[str] | None = None) -> int:
    """Broadcast until stopped; return the exit code."""
    expect_no_arguments(
        "fixed_frame_tf2_broadcaster", "Broadcast the frame carrot1, two metres to the left of turtle1.", args
    )
    return run_program(args, lambda: spin(FixedFrameBroadcaster()))
