"""Read and set the parameters of another node."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.task import Future


class Tuner(Node):
    """Sets the thruster's parameters."""

    def __init__(self) -> None:
        super().__init__("tuner")
        self.parameters = AsyncParameterClient(self, "thruster")

    def finish(self, future: Future[Any]) -> Any:
        """Spin until the response is received, and return it."""
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def tune(self) -> bool:
        """Print the parameters, and set valid and invalid values; return False if the thruster is not running."""
        log = self.get_logger()
        if not self.parameters.wait_for_services(timeout_sec=10.0):
            log.error("There is no thruster")
            return False

        names = self.finish(self.parameters.list_parameters(depth=1)).result.names
        log.info(f"Its parameters: {', '.join(sorted(names))}")
        descriptors = self.finish(self.parameters.describe_parameters(["thrust"])).descriptors
        for descriptor in descriptors:
            allowed = descriptor.floating_point_range[0]
            log.info(
                f"{descriptor.name}, {descriptor.description}: {allowed.from_value} to {allowed.to_value}"
            )

        wishes = [
            Parameter("thrust", Parameter.Type.DOUBLE, 7.5),
            Parameter("thrust", Parameter.Type.DOUBLE, 70.5),
            Parameter("serial", Parameter.Type.INTEGER, 1),
            Parameter("side", Parameter.Type.STRING, "up"),
            Parameter("side", Parameter.Type.STRING, "right"),
        ]
        for wish in wishes:
            result = self.finish(self.parameters.set_parameters([wish])).results[0]
            log.info(f"{wish.name} = {wish.value}: {'done' if result.successful else result.reason}")

        values = self.finish(self.parameters.get_parameters(["thrust", "side"])).values
        log.info(f"In the end: {', '.join(str(parameter_value_to_python(value)) for value in values)}")
        return True


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        return 0 if Tuner().tune() or not rclpy.ok() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
