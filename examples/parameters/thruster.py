"""Declare parameters, describe them, and handle changes by other nodes."""

from __future__ import annotations

import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter


class Thruster(Node):
    """A thrust between 0 and 10 N, a side to push to, and a read-only serial number."""

    def __init__(self) -> None:
        super().__init__("thruster")
        thrust_range = FloatingPointRange(from_value=0.0, to_value=10.0, step=0.0)
        self.declare_parameter(
            "thrust", 1.0, ParameterDescriptor(description="in newton", floating_point_range=[thrust_range])
        )
        self.declare_parameter("side", "left", ParameterDescriptor(additional_constraints="left or right"))
        self.declare_parameter("serial", 4711, ParameterDescriptor(read_only=True))
        self.add_pre_set_parameters_callback(self.before_set)
        self.add_on_set_parameters_callback(self.on_set)
        self.add_post_set_parameters_callback(self.after_set)
        self.get_logger().info(f"Thrust {self.get_parameter('thrust').value} N")

    def before_set(self, parameters: list[Parameter]) -> list[Parameter]:
        """Modify the requested values: a new side starts with little thrust."""
        names = [parameter.name for parameter in parameters]
        if "side" in names and "thrust" not in names:
            return [*parameters, Parameter("thrust", Parameter.Type.DOUBLE, 0.5)]
        return parameters

    def on_set(self, parameters: list[Parameter]) -> SetParametersResult:
        """Accept or reject the values, before they are set."""
        for parameter in parameters:
            if parameter.name == "side" and parameter.value not in ("left", "right"):
                return SetParametersResult(successful=False, reason=f"there is no side {parameter.value}")
        return SetParametersResult(successful=True)

    def after_set(self, parameters: list[Parameter]) -> None:
        """Act on the values after they are set."""
        for parameter in parameters:
            self.get_logger().info(f"Now {parameter.name} is {parameter.value}")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Thruster())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
