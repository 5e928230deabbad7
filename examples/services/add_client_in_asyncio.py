"""Call a service from asyncio: several requests at once, each with a time limit.

A thread spins the node. An `await` of rclpy's future lets the other coroutines run until the response has come.
"""

from __future__ import annotations

import asyncio
import sys
import threading

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AddClientInAsyncio(Node):
    """Asks /add_two_ints; something else has to spin it."""

    def __init__(self) -> None:
        super().__init__("add_client_in_asyncio")
        self.client = self.create_client(AddTwoInts, "add_two_ints")

    async def wait(self) -> bool:
        """Return whether the service came, before the program was ended."""
        while not await asyncio.to_thread(self.client.wait_for_service, 1.0):
            if not rclpy.ok():
                return False
            self.get_logger().info("Waiting for the service ...")
        return True

    async def add(self, a: int, b: int) -> int:
        response = await self.client.call_async(AddTwoInts.Request(a=a, b=b))
        self.get_logger().info(f"{a} + {b} = {response.sum}")
        return response.sum

    async def add_all(self, pairs: list[tuple[int, int]]) -> list[int]:
        """Return the sums, which are asked for at once.

        Raises:
            asyncio.TimeoutError: one didn't come within 5 s.
        """
        return await asyncio.gather(*(asyncio.wait_for(self.add(a, b), 5.0) for a, b in pairs))


async def work(node: AddClientInAsyncio) -> int:
    if not await node.wait():
        return 0
    try:
        sums = await node.add_all([(1, 2), (3, 4), (5, 6)])
    except asyncio.TimeoutError:
        node.get_logger().error("No answer")
        return 1
    node.get_logger().info(f"In all {sum(sums)}")
    return 0


def spin(node: Node) -> None:
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        node = AddClientInAsyncio()
        threading.Thread(target=spin, args=(node,), daemon=True).start()
        return asyncio.run(work(node))
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
