"""add_two_ints_client_async: request the sum of 2 and 3, and check between callbacks for the response."""

from __future__ import annotations

from tfloom.demos.demo_nodes_py.add_two_ints_client import wait_for_server
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.client_library import ok, spin_once
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main"]


def call() -> None:
    """Send a request, and log the response once a check finds it."""
    node = Node("add_two_ints_client")
    client = node.create_client(AddTwoInts, "add_two_ints")
    if not wait_for_server(client):
        return
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    while ok() and not future.done():
        spin_once(node)
    response = future.result()
    if response is not None:
        node.get_logger().info(f"Result of add_two_ints: {response.sum}")


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client_async", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, call)
