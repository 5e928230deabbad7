"""What is said of something that is given in place of a node."""

from __future__ import annotations

from tfloom.given_text import given_text

__all__ = ["node_error"]


def node_error(call: str, node: object) -> TypeError | None:
    """Return the error of what `call` got in place of a node, or None if it is one."""
    if isinstance(node, type):
        return TypeError(f"{call}() needs a node, got the class {node.__name__}: write {node.__name__}(…)")
    if hasattr(node, "get_name") and hasattr(node, "create_publisher"):
        return None
    if node is None:
        return TypeError(f"{call}() needs a node, got None: does the function that creates it return it?")
    return TypeError(f"{call}() needs a node, got {given_text(node)}")
