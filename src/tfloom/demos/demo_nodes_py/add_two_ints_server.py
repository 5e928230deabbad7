"""add_two_ints_server: reply to requests with the sum of two integers."""

from __future__ import annotations

from tfloom.interfaces.example_interfaces.srv import AddTwoInts, AddTwoInts_Request, AddTwoInts_Response
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["AddTwoIntsServer", "main"]


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


def main(args: list[str] | None = None) -> int:
    """Serve until stopped; return the exit code."""
    expect_no_arguments(
        "add_two_ints_server", "Serve add_two_ints: reply with the sum of two integers.", args
    )
    return run_program(args, lambda: spin(AddTwoIntsServer()))
