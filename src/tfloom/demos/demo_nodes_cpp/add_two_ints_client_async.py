"""add_two_ints_client_async: as add_two_ints_client, from the outside."""

from __future__ import annotations

from tfloom.demos.demo_nodes_cpp import add_two_ints_client

__all__ = ["main"]


def main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    return add_two_ints_client.main(args, name="add_two_ints_client_async")
