"""add_two_ints_client: request the sum of 2 and 3, and wait for the response."""

from __future__ import annotations

from tfloom.demos.demo_nodes_py.add_two_ints_client import wait_for_server
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.client_library import spin_until_future_complete
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["call", "main"]


def call() -> None:
    """Send a request once the server is there, and log the response; the waits are logged, too."""
    node = Node("add_two_ints_client")
    client = node.create_client(AddTwoInts, "add_two_ints")
    if not wait_for_server(client, node.get_logger().info):
        return
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    spin_until_future_complete(node, future)
    response = future.result()
    if response is not None:
        node.get_logger().info(f"Result of add_two_ints: {response.sum}")


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, call)
