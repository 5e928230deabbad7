"""add_two_ints_client_async: request the sum of 2 and 3, and check between callbacks for the response."""

from __future__ import annotations

from functools import partial
from typing import Any

from tfloom.demos.demo_nodes_py.add_two_ints_client import call
from tfloom.node.client_library import ok, spin_once
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main"]


def spin_with_checks(node: Node, future: Future[Any]) -> None:
    """Spin a node, and check after each callback whether a future is done."""
    while ok() and not future.done():
        spin_once(node)


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments("add_two_ints_client_async", "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, partial(call, spin_with_checks))
