"""Call a service with the blocking `call`, while another thread spins."""

from __future__ import annotations

import threading

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.client import Client
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def add_up(node: Node, client: Client, numbers: list[int]) -> int:
    """Return the sum of `numbers`, by one call for each; another thread must spin `node`."""
    total = 0
    for number in numbers:
        response = client.call(AddTwoInts.Request(a=total, b=number))
        if response is None:  # the context was shut down
            break
        node.get_logger().info(f"{total} + {number} = {response.sum}")
        total = response.sum
    return total


def spin(node: Node) -> None:
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        node = Node("add_client_in_thread")
        client = node.create_client(AddTwoInts, "add_two_ints")
        spinner = threading.Thread(target=spin, args=(node,), daemon=True)
        spinner.start()
        client.wait_for_service()
        total = add_up(node, client, [1, 2, 3, 4])
        node.get_logger().info(f"In all {total}")
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
