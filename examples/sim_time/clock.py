"""Publish the /clock of a simulation: ten simulated seconds in each real second."""

from __future__ import annotations

import rclpy
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMessage

STEP = Duration(seconds=0.2)


class SimulationClock(Node):
    """Starts at 100 s. Its timer uses a steady clock, because the node's own clock follows /clock."""

    def __init__(self) -> None:
        super().__init__("simulation_clock")
        self.publisher = self.create_publisher(ClockMessage, "/clock", 10)
        self.time = Time(seconds=100, clock_type=ClockType.ROS_TIME)
        self.timer = self.create_timer(0.02, self.on_timer, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def on_timer(self) -> None:
        self.time += STEP
        self.publisher.publish(ClockMessage(clock=self.time.to_msg()))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(SimulationClock())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
