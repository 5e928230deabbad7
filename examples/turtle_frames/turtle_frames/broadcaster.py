"""Subscribe to a turtle's pose, and broadcast it as the transform world_from_turtle."""

import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Broadcaster(Node):
    """Broadcasts world_from_turtle for each pose of the turtle."""

    def __init__(self) -> None:
        super().__init__("broadcaster")
        self.turtle = self.declare_parameter("turtle", "turtle1").value
        self.world = self.declare_parameter("world", "world").value
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f"/{self.turtle}/pose", self.on_pose, 10)
        self.get_logger().info(f"Broadcasting {self.world} to {self.turtle}")

    def on_pose(self, pose: Pose) -> None:
        """Broadcast the pose [m, rad] as a transform, stamped with the current time."""
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = self.world
        transform.child_frame_id = self.turtle
        transform.transform.translation.x = pose.x
        transform.transform.translation.y = pose.y
        # A turn about z by theta is the quaternion (0, 0, sin(theta/2), cos(theta/2)).
        transform.transform.rotation.z = math.sin(pose.theta / 2)
        transform.transform.rotation.w = math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(transform)


def main() -> None:
    """Broadcast until Ctrl-C."""
    rclpy.init()
    node = Broadcaster()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
