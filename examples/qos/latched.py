"""Keep the last message for subscriptions that join late: durability transient local."""

from __future__ import annotations

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

LATCHED = QoSProfile(
    depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, reliability=ReliabilityPolicy.RELIABLE
)


class MapMaker(Node):
    """Publishes a map, once."""

    def __init__(self) -> None:
        super().__init__("map_maker")
        self.publisher = self.create_publisher(String, "city_map", LATCHED)
        self.publisher.publish(String(data="a map of the old town"))


class Tourist(Node):
    """Subscribes a second later, and still receives the map."""

    def __init__(self) -> None:
        super().__init__("tourist")
        self.timer = self.create_timer(1.0, self.arrive)

    def arrive(self) -> None:
        self.timer.cancel()
        self.subscription = self.create_subscription(String, "city_map", self.on_map, LATCHED)

    def on_map(self, message: String) -> None:
        self.get_logger().info(f"I have {message.data}")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        executor.add_node(MapMaker())
        executor.add_node(Tourist())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
