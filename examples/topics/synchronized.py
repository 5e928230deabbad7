"""Match the messages of two sensors by their stamps, with message_filters."""

from __future__ import annotations

import rclpy
from message_filters import ApproximateTimeSynchronizer, Subscriber
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from sensor_msgs.msg import FluidPressure, Temperature


class Weather(Node):
    """Publishes temperature and pressure, shortly after each other."""

    def __init__(self) -> None:
        super().__init__("weather")
        self.temperature = self.create_publisher(Temperature, "temperature", 10)
        self.pressure = self.create_publisher(FluidPressure, "pressure", 10)
        self.timer = self.create_timer(0.2, self.on_timer)
        self.count = 0

    def on_timer(self) -> None:
        self.count += 1
        temperature = Temperature(temperature=20.0 + self.count)
        temperature.header.stamp = self.get_clock().now().to_msg()
        self.temperature.publish(temperature)
        pressure = FluidPressure(fluid_pressure=101_000.0 + self.count)
        pressure.header.stamp = self.get_clock().now().to_msg()
        self.pressure.publish(pressure)


class Station(Node):
    """Prints each temperature with the pressure nearest in time."""

    def __init__(self) -> None:
        super().__init__("station")
        filters = [Subscriber(self, Temperature, "temperature"), Subscriber(self, FluidPressure, "pressure")]
        self.synchronizer = ApproximateTimeSynchronizer(filters, queue_size=10, slop=0.05)
        self.synchronizer.registerCallback(self.on_pair)

    def on_pair(self, temperature: Temperature, pressure: FluidPressure) -> None:
        self.get_logger().info(f"{temperature.temperature:.0f} °C at {pressure.fluid_pressure:.0f} Pa")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        executor.add_node(Weather())
        executor.add_node(Station())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
