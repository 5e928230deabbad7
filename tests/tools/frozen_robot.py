"""A program to freeze: a topic, transforms, a type found by its name, and a package of tfloom-interfaces."""

from __future__ import annotations

import pickle

import rclpy
from geometry_msgs.msg import TransformStamped
from nav2_msgs.action import NavigateToPose
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from rosidl_runtime_py.utilities import get_message
from std_msgs.msg import String
from tf2_ros import Buffer, TransformBroadcaster, TransformListener
from tf_transformations import euler_from_quaternion, quaternion_from_euler


class Robot(Node):
    """Broadcasts odom_from_base, and publishes the yaw of map_from_base when it is known."""

    def __init__(self) -> None:
        super().__init__("robot")
        self.yaws = self.create_publisher(String, "yaws", 10)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.step)
        odometry = get_message("nav_msgs/msg/Odometry")
        self.get_logger().info(f"{odometry.__name__} {NavigateToPose.__name__}")
        self.get_logger().info(
            f"modules: {odometry.__module__} {String.__module__} {NavigateToPose.__module__}"
        )
        for message in (odometry(), String(data="kept"), NavigateToPose.Goal()):
            assert pickle.loads(pickle.dumps(message)) == message

    def step(self) -> None:
        """Broadcast, look up, publish."""
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = "odom"
        transform.child_frame_id = "base"
        rotation = transform.transform.rotation
        rotation.x, rotation.y, rotation.z, rotation.w = quaternion_from_euler(0.0, 0.0, 0.5)
        self.broadcaster.sendTransform(transform)
        if self.buffer.can_transform("map", "base", Time()):
            found = self.buffer.lookup_transform("map", "base", Time()).transform.rotation
            yaw = euler_from_quaternion([found.x, found.y, found.z, found.w])[2]
            self.yaws.publish(String(data=f"yaw {yaw:.2f}"))


def main() -> None:
    """Run the node until Ctrl-C."""
    rclpy.init()
    node = Robot()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        print("stopped")
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
