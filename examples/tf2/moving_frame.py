"""Broadcast a moving frame: a robot that drives on a circle."""

from __future__ import annotations

import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import TransformBroadcaster

RADIUS_M = 2.0
TURN_RAD_S = 1.0


class MovingFrame(Node):
    """Broadcasts world to base, 50 times a second."""

    def __init__(self) -> None:
        super().__init__("moving_frame")
        self.broadcaster = TransformBroadcaster(self)
        self.start = self.get_clock().now()
        self.timer = self.create_timer(0.02, self.on_timer)

    def pose(self, now: Time) -> TransformStamped:
        """Return the base's pose on a circle around the world's origin, facing ahead."""
        angle = TURN_RAD_S * (now - self.start).nanoseconds / 1e9
        heading = angle + math.pi / 2
        transform = TransformStamped()
        transform.header.stamp = now.to_msg()
        transform.header.frame_id = "world"
        transform.child_frame_id = "base"
        transform.transform.translation.x = RADIUS_M * math.cos(angle)
        transform.transform.translation.y = RADIUS_M * math.sin(angle)
        transform.transform.rotation.z = math.sin(heading / 2)
        transform.transform.rotation.w = math.cos(heading / 2)
        return transform

    def on_timer(self) -> None:
        self.broadcaster.sendTransform(self.pose(self.get_clock().now()))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(MovingFrame())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
