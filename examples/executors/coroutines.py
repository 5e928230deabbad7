"""Await one service in the callback of another: coroutines, on one thread.

A coroutine occupies its callback group until it ends, so the client that it awaits is in another group.
"""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node


class Doubler(Node):
    """A server of /double_sum, which calls /add_two_ints."""

    def __init__(self) -> None:
        super().__init__("doubler")
        self.client = self.create_client(
            AddTwoInts, "add_two_ints", callback_group=MutuallyExclusiveCallbackGroup()
        )
        self.service = self.create_service(AddTwoInts, "double_sum", self.on_request)

    async def on_request(
        self, request: AddTwoInts.Request, response: AddTwoInts.Response
    ) -> AddTwoInts.Response:
        answer = await self.client.call_async(request)
        if answer is not None:
            response.sum = 2 * answer.sum
        return response


class Asker(Node):
    """Calls /double_sum every 0.5 s."""

    def __init__(self) -> None:
        super().__init__("asker")
        self.client = self.create_client(
            AddTwoInts, "double_sum", callback_group=MutuallyExclusiveCallbackGroup()
        )
        self.timer = self.create_timer(0.5, self.on_timer)
        self.count = 0

    async def on_timer(self) -> None:
        if not self.client.service_is_ready():
            return
        self.count += 1
        answer = await self.client.call_async(AddTwoInts.Request(a=self.count, b=1))
        if answer is not None:
            self.get_logger().info(f"2 * ({self.count} + 1) = {answer.sum}")


async def greet(node: Node) -> str:
    """Run as a task of the executor, beside the callbacks."""
    node.get_logger().info("A task greets you")
    return node.get_name()


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        asker = Asker()
        executor.add_node(Doubler())
        executor.add_node(asker)
        executor.create_task(greet(asker))
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
