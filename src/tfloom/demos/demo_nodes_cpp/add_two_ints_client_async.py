"""add_two_ints_client_async: as add_two_ints_client, from the outside."""

from __future__ import annotations

from tfloom.demos.demo_nodes_cpp.add_two_ints_client import call
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main"]


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client_async", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, call)
