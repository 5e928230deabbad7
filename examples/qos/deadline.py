"""Request a message every 0.2 s, and get an event when one is late."""

from __future__ import annotations

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import (
    PublisherEventCallbacks,
    QoSOfferedDeadlineMissedInfo,
    QoSRequestedDeadlineMissedInfo,
    SubscriptionEventCallbacks,
)
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

PUNCTUAL = QoSProfile(depth=10, deadline=Duration(seconds=0.2))


class Promiser(Node):
    """Offers a deadline of 0.2 s, meets it five times, and pauses."""

    def __init__(self) -> None:
        super().__init__("promiser")
        events = PublisherEventCallbacks(deadline=self.on_missed)
        self.publisher = self.create_publisher(String, "promised", PUNCTUAL, event_callbacks=events)
        self.timer = self.create_timer(0.1, self.on_timer)
        self.count = 0

    def on_timer(self) -> None:
        self.count += 1
        if self.count % 10 < 5:
            self.publisher.publish(String(data=f"Message {self.count}"))

    def on_missed(self, event: QoSOfferedDeadlineMissedInfo) -> None:
        self.get_logger().warning(f"I promised more: {event.total_count} missed")


class Waiter(Node):
    """Requests the deadline, and logs each event."""

    def __init__(self) -> None:
        super().__init__("waiter")
        events = SubscriptionEventCallbacks(deadline=self.on_missed)
        self.subscription = self.create_subscription(
            String, "promised", self.on_message, PUNCTUAL, event_callbacks=events
        )

    def on_message(self, message: String) -> None:
        self.get_logger().info(f"I got {message.data}")

    def on_missed(self, event: QoSRequestedDeadlineMissedInfo) -> None:
        self.get_logger().warning(f"I was promised more: {event.total_count} missed")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        executor.add_node(Promiser())
        executor.add_node(Waiter())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
