"""Broadcast a static frame once: the laser on its robot."""

from __future__ import annotations

import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster


class StaticFrame(Node):
    """Broadcasts base to laser: 0.2 m ahead, 0.5 m up, facing back."""

    def __init__(self) -> None:
        super().__init__("static_frame")
        self.broadcaster = StaticTransformBroadcaster(self)
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = "base"
        transform.child_frame_id = "laser"
        transform.transform.translation.x = 0.2
        transform.transform.translation.z = 0.5
        transform.transform.rotation.z = math.sin(math.pi / 2)
        transform.transform.rotation.w = math.cos(math.pi / 2)
        self.broadcaster.sendTransform(transform)
        self.get_logger().info("The laser is on its base")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(StaticFrame())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
