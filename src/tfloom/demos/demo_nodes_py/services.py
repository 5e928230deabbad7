"""Services: add_two_ints_server replies with the sum of two integers, and the clients request that of 2 and 3."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from tfloom.interfaces.example_interfaces.srv import AddTwoInts, AddTwoInts_Request, AddTwoInts_Response
from tfloom.node.client_library import ok, spin, spin_once, spin_until_future_complete
from tfloom.node.endpoints.client import Client
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = [
    "AddTwoIntsServer",
    "add_two_ints_client_async_main",
    "add_two_ints_client_main",
    "add_two_ints_server_main",
    "wait_for_server",
]


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


def add_two_ints_client_main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, call)


def spin_with_checks(node: Node, future: Future[Any]) -> None:
    """Spin a node, and check after each callback whether a future is done."""
    while ok() and not future.done():
        spin_once(node)


def add_two_ints_client_async_main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client_async", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, partial(call, spin_with_checks))


class AddTwoIntsServer(Node):
    """Serves add_two_ints."""

    def __init__(self) -> None:
        super().__init__("add_two_ints_server")
        self.srv = self.create_service(AddTwoInts, "add_two_ints", self.add_two_ints_callback)

    def add_two_ints_callback(
        self, request: AddTwoInts_Request, response: AddTwoInts_Response
    ) -> AddTwoInts_Response:
        """Reply to a request; a sum beyond 64 bits wraps around, as in C++."""
        response.sum = (request.a + request.b + 2**63) % 2**64 - 2**63
        self.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response


def add_two_ints_server_main(args: list[str] | None = None) -> int:
    """Serve until stopped; return the exit code."""
    expect_no_arguments(
        "add_two_ints_server", "Serve add_two_ints: reply with the sum of two integers.", args
    )
    return run_program(args, lambda: spin(AddTwoIntsServer()))
