"""add_two_ints_client: request the sum of 2 and 3, and wait for the response."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.client_library import ok, spin_until_future_complete
from tfloom.node.endpoints.client import Client
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main", "wait_for_server"]


def wait_for_server(client: Client, report: Callable[[str], object] | None = None) -> bool:
    """Wait until the server is ready, and report a line each second; return False if the program was stopped before."""
    while ok():
        if client.wait_for_service(timeout_sec=1.0):
            return True
        if ok():
            (report or _print)("service not available, waiting again...")
    return False


def _print(text: str) -> None:
    print(text, flush=True)


def call(
    spin: Callable[[Node, Future[Any]], object] = spin_until_future_complete, *, logs_waits: bool = False
) -> None:
    """Send a request once the server is there, spin until the response arrives, and log it.

    Args:
        spin: Spins a node until a future is done, or the program is stopped.
        logs_waits: Whether waits for the server are logged, too; else they are printed.
    """
    node = Node("add_two_ints_client")
    client = node.create_client(AddTwoInts, "add_two_ints")
    if not wait_for_server(client, node.get_logger().info if logs_waits else None):
        return
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    spin(node, future)
    response = future.result()
    if response is not None:
        node.get_logger().info(f"Result of add_two_ints: {response.sum}")


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, call)
