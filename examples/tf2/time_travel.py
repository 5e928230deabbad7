"""Look up the base's pose now relative to its pose 0.5 s ago: two times, and a fixed frame between them."""

from __future__ import annotations

import math

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener


class TimeTravel(Node):
    """Looks up the base's motion five times a second."""

    def __init__(self) -> None:
        super().__init__("time_travel")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.timer = self.create_timer(0.2, self.on_timer)

    def on_timer(self) -> None:
        now = self.get_clock().now()
        then = now - Duration(seconds=0.5)
        try:
            moved = self.buffer.lookup_transform_full(
                target_frame="base",
                target_time=then,
                source_frame="base",
                source_time=now,
                fixed_frame="world",
                timeout=Duration(seconds=0.5),
            )
        except TransformException as error:
            self.get_logger().info(f"Not yet: {error}")
            return
        way = moved.transform.translation
        turn = 2 * math.atan2(moved.transform.rotation.z, moved.transform.rotation.w)
        self.get_logger().info(
            f"In 0.5 s it moved {way.x:.2f} ahead, {way.y:.2f} left, and turned {turn:.2f} rad"
        )


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()  # transforms are received while a callback waits for them
    try:
        executor.add_node(TimeTravel())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
