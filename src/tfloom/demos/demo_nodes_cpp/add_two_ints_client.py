"""add_two_ints_client: request the sum of 2 and 3, and wait for the response; the waits are logged, too."""

from __future__ import annotations

from functools import partial

from tfloom.demos.demo_nodes_py.add_two_ints_client import call
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main"]


def main(args: list[str] | None = None, *, name: str = "add_two_ints_client") -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments(name, "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, partial(call, logs_waits=True))
