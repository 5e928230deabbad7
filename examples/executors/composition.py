"""Run several nodes of one process in one executor, each with its own name, namespace and remapped topics."""

from __future__ import annotations

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int64


class Source(Node):
    """Publishes 1, 2, 3 … on `numbers`."""

    def __init__(self, name: str) -> None:
        super().__init__(name, namespace="pipeline")
        self.publisher = self.create_publisher(Int64, "numbers", 10)
        self.timer = self.create_timer(0.2, self.on_timer)
        self.count = 0

    def on_timer(self) -> None:
        self.count += 1
        self.publisher.publish(Int64(data=self.count))


class Square(Node):
    """Publishes the square of each number from `numbers` on `squares`."""

    def __init__(self, name: str, remappings: dict[str, str]) -> None:
        rules = [word for old, new in remappings.items() for word in ("-r", f"{old}:={new}")]
        super().__init__(name, namespace="pipeline", cli_args=["--ros-args", *rules] if rules else None)
        self.publisher = self.create_publisher(Int64, "squares", 10)
        self.subscription = self.create_subscription(Int64, "numbers", self.on_number, 10)

    def on_number(self, message: Int64) -> None:
        square = Int64(data=message.data**2)
        self.publisher.publish(square)
        self.get_logger().info(f"{message.data} squared is {square.data}")


def make_nodes() -> list[Node]:
    """Return a source and two squaring nodes; the second one's input is the first one's output."""
    return [
        Source("source"),
        Square("first", {}),
        Square("second", {"numbers": "squares", "squares": "fourth_powers"}),
    ]


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        for node in make_nodes():
            executor.add_node(node)
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
