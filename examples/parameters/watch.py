"""Watch a parameter of another node, whichever node sets it."""

from __future__ import annotations

import rclpy
from rcl_interfaces.msg import Parameter as ParameterMessage
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python
from rclpy.parameter_event_handler import ParameterEventHandler


class Watch(Node):
    """Logs each change of the thruster's thrust."""

    def __init__(self) -> None:
        super().__init__("watch")
        self.handler = ParameterEventHandler(self)
        self.callback = self.handler.add_parameter_callback("thrust", "/thruster", self.on_change)

    def on_change(self, parameter: ParameterMessage) -> None:
        self.get_logger().info(f"{parameter.name} became {parameter_value_to_python(parameter.value)}")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Watch())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
