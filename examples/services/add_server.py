"""Offer a service that adds two integers."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AddServer(Node):
    """A server of /add_two_ints."""

    def __init__(self) -> None:
        super().__init__("add_server")
        self.service = self.create_service(AddTwoInts, "add_two_ints", self.on_request)

    def on_request(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(f"Asked for {request.a} + {request.b}")
        return response


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(AddServer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
