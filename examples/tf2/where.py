"""Look up a frame: at the latest known time, now with a timeout, and for a point."""

from __future__ import annotations

import rclpy
import tf2_geometry_msgs  # noqa: F401  # registers PointStamped with the buffer
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Where(Node):
    """Looks up the laser's pose in the world five times a second."""

    def __init__(self) -> None:
        super().__init__("where")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.timer = self.create_timer(0.2, self.on_timer)

    def on_timer(self) -> None:
        log = self.get_logger()
        try:
            latest = self.buffer.lookup_transform("world", "laser", Time())
            now = self.get_clock().now()
            current = self.buffer.lookup_transform("world", "laser", now, timeout=Duration(seconds=0.5))
            seen = PointStamped()
            seen.header.frame_id = "laser"
            seen.header.stamp = current.header.stamp
            seen.point.x = 1.0
            point = self.buffer.transform(seen, "world").point
        except TransformException as error:
            log.info(f"Not yet: {error}")
            return
        at = latest.transform.translation
        log.info(f"The laser is at {at.x:.2f}, {at.y:.2f}, {at.z:.2f}")
        log.info(f"What it sees is at {point.x:.2f}, {point.y:.2f}, {point.z:.2f}")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()  # transforms are received while a callback waits for them
    try:
        executor.add_node(Where())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
