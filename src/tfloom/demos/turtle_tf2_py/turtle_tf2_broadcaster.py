"""turtle_tf2_broadcaster: broadcast a turtle's pose on tf, at each message of its pose."""

from __future__ import annotations

import math

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.turtlesim_types import Pose
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster


class FramePublisher(Node):
    """Broadcasts world_from_turtle for the turtle of the parameter `turtlename`."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_publisher")
        self.turtlename = str(self.declare_parameter("turtlename", "turtle1").value)
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f"/{self.turtlename}/pose", self.on_pose, 1)

    def on_pose(self, pose: Pose) -> None:
        """Broadcast the pose [m, rad], with the present time; skip one that isn't all finite numbers."""
        if not all(map(math.isfinite, (pose.x, pose.y, pose.theta))):
            self.get_logger().warning(
                f"Ignoring a pose of [{self.turtlename}]: not numbers: {pose.x}, {pose.y}, {pose.theta}",
                throttle_duration_sec=1.0,
            )
            return
        world_from_turtle = TransformStamped(child_frame_id=self.turtlename)
        world_from_turtle.header.stamp = self.get_clock().now().to_msg()
        world_from_turtle.header.frame_id = "world"
        world_from_turtle.transform.translation.x = pose.x
        world_from_turtle.transform.translation.y = pose.y
        # A rotation by theta about z is the quaternion (0, 0, sin(theta/2), cos(theta/2)).
        world_from_turtle.transform.rotation.z = math.sin(pose.theta / 2)
        world_from_turtle.transform.rotation.w = math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(world_from_turtle)


def main(args: list[str] | None = None) -> int:
    """Broadcast until stopped; return the exit code."""
    expect_no_arguments(
        "turtle_tf2_broadcaster", "Broadcast a turtle's pose on tf: --ros-args -p turtlename:=turtle1.", args
    )
    return run_program(args, lambda: spin(FramePublisher()))
