"""Match a best-effort publisher with a compatible subscription, and see an incompatible one."""

from __future__ import annotations

import rclpy
from rclpy.event_handler import (
    PublisherEventCallbacks,
    QoSPublisherMatchedInfo,
    QoSRequestedIncompatibleQoSInfo,
    SubscriptionEventCallbacks,
)
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_policy_name_from_kind, qos_profile_sensor_data
from std_msgs.msg import String


class Radio(Node):
    """Publishes with best effort."""

    def __init__(self) -> None:
        super().__init__("radio")
        self.publisher = self.create_publisher(
            String,
            "news",
            qos_profile_sensor_data,
            event_callbacks=PublisherEventCallbacks(matched=self.on_matched),
        )

    def on_matched(self, event: QoSPublisherMatchedInfo) -> None:
        self.get_logger().info(f"Listeners: {event.current_count}")


class Listeners(Node):
    """One subscription accepts best effort, the other requests reliability."""

    def __init__(self) -> None:
        super().__init__("listeners")
        self.easy = self.create_subscription(String, "news", self.on_news, qos_profile_sensor_data)
        self.strict = self.create_subscription(
            String,
            "news",
            self.on_news,
            QoSProfile(depth=5, reliability=ReliabilityPolicy.RELIABLE),
            event_callbacks=SubscriptionEventCallbacks(incompatible_qos=self.on_incompatible),
        )

    def on_news(self, message: String) -> None:
        self.get_logger().info(message.data)

    def on_incompatible(self, event: QoSRequestedIncompatibleQoSInfo) -> None:
        policy = qos_policy_name_from_kind(event.last_policy_kind)
        self.get_logger().warning(f"No news for the strict one: {policy} doesn't fit")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        executor.add_node(Radio())
        executor.add_node(Listeners())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
