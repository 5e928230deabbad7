"""Call a service with `call_async`, and spin until its response is received."""

from __future__ import annotations

import sys

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AddClient(Node):
    """A client of /add_two_ints."""

    def __init__(self) -> None:
        super().__init__("add_client")
        self.client = self.create_client(AddTwoInts, "add_two_ints")

    def ask(self, a: int, b: int) -> int | None:
        """Return the sum; None if no response was received."""
        while not self.client.wait_for_service(timeout_sec=1.0):
            if not rclpy.ok():
                return None
            self.get_logger().info("Waiting for the service ...")
        future = self.client.call_async(AddTwoInts.Request(a=a, b=b))
        rclpy.spin_until_future_complete(self, future, timeout_sec=5.0)
        response = future.result()
        if response is None:
            self.get_logger().error("No answer")
            return None
        self.get_logger().info(f"{a} + {b} = {response.sum}")
        return int(response.sum)


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        return 0 if AddClient().ask(2, 3) is not None or not rclpy.ok() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
