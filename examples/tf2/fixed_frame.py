"""Add a frame to an existing tree: a carrot one metre ahead of the robot."""

from __future__ import annotations

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class FixedFrame(Node):
    """Broadcasts base to carrot. The offset is constant here, but may change, unlike that of a static transform."""

    def __init__(self) -> None:
        super().__init__("fixed_frame")
        self.declare_parameter("ahead", 1.0)
        self.broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(0.05, self.on_timer)

    def on_timer(self) -> None:
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = "base"
        transform.child_frame_id = "carrot"
        transform.transform.translation.x = self.get_parameter("ahead").value
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(FixedFrame())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
