"""A managed node, which other nodes configure, activate, deactivate and shut down."""

from __future__ import annotations

from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.timer import Timer
from std_msgs.msg import Float64


class Sensor(LifecycleNode):
    """Publishes measurements while it is active."""

    def __init__(self) -> None:
        super().__init__("sensor")
        self.publisher: Any = None
        self.timer: Timer | None = None
        self.count = 0

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the publisher and the timer; a lifecycle publisher is silent until the node is active."""
        self.publisher = self.create_lifecycle_publisher(Float64, "measured", 10)
        self.timer = self.create_timer(0.1, self.measure)
        self.get_logger().info("Configured")
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info("Activated")
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info(f"Deactivated after {self.count} measurements")
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.destroy_entities()
        self.get_logger().info("Cleaned up")
        return super().on_cleanup(state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.destroy_entities()
        self.get_logger().info("Shut down")
        return super().on_shutdown(state)

    def destroy_entities(self) -> None:
        """Destroy what `on_configure` created."""
        if self.timer is not None:
            self.destroy_timer(self.timer)
            self.timer = None
        if self.publisher is not None:
            self.destroy_lifecycle_publisher(self.publisher)
            self.publisher = None

    def measure(self) -> None:
        if self.publisher is not None and self.publisher.is_activated:
            self.count += 1
            self.publisher.publish(Float64(data=float(self.count)))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Sensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
