"""Use simulated time: a timer of one second that follows /clock."""

from __future__ import annotations

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter


class Simulated(Node):
    """Logs each simulated second. For other nodes, set the parameter by `-p use_sim_time:=true`."""

    def __init__(self) -> None:
        super().__init__(
            "simulated", parameter_overrides=[Parameter("use_sim_time", Parameter.Type.BOOL, True)]
        )
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self) -> None:
        now = self.get_clock().now()
        self.get_logger().info(f"It is {now.nanoseconds / 1e9:.1f} s")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Simulated())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
