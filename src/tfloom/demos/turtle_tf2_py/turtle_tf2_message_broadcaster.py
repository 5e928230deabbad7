"""turtle_tf2_message_broadcaster: publish turtle3's position as points in the world, for a tf2 message filter."""

from __future__ import annotations

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.turtlesim_types import Pose


class PointPublisher(Node):
    """Publishes turtle3's position on turtle3/turtle_point_stamped, at each message of its pose."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_message_broadcaster")
        self.publisher = self.create_publisher(PointStamped, "turtle3/turtle_point_stamped", 1)
        self.create_subscription(Pose, "turtle3/pose", self.on_pose, 10)

    def on_pose(self, pose: Pose) -> None:
        """Publish the point [m], with the present time."""
        point = PointStamped()
        point.header.stamp = self.get_clock().now().to_msg()
        point.header.frame_id = "world"
        point.point.x, point.point.y = pose.x, pose.y
        self.publisher.publish(point)


def main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    expect_no_arguments(
        "turtle_tf2_message_broadcaster", "Publish the position of turtle3 as points in the world.", args
    )
    return run_program(args, lambda: spin(PointPublisher()))
