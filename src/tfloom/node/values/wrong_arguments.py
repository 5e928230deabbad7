"""What is said of something that is given in place of a node, an executor or a callback."""

from __future__ import annotations

from typing import Any

from tfloom.common.text import given_text

__all__ = ["executor_error", "node_error", "not_callable"]


def node_error(call: str, node: object) -> TypeError | None:
    """Return the error of what `call` got in place of a node, or None if it is one."""
    if isinstance(node, type):
        return TypeError(f"{call}() needs a node, got the class {node.__name__}: write {node.__name__}(…)")
    if hasattr(node, "get_name") and hasattr(node, "create_publisher"):
        return None
    if node is None:
        return TypeError(f"{call}() needs a node, got None: does the function that creates it return it?")
    return TypeError(f"{call}() needs a node, got {given_text(node)}")


def executor_error(call: str, executor: object) -> TypeError | None:
    """Return the error of what `call` got in place of an executor, or None if it is one, or None."""
    if executor is None or (hasattr(executor, "add_node") and not isinstance(executor, type)):
        return None
    given = (
        f"the class {executor.__name__}: write {executor.__name__}()" if isinstance(executor, type) else None
    )
    return TypeError(f"{call}() needs an executor, got {given or given_text(executor)}")


def not_callable(callback: Any) -> str:
    """Return what a program gave in place of a callback, and what was probably meant."""
    if callback is None:
        return (
            "got None: if it is the result of a call, as of `callback()`, write `callback`, without brackets"
        )
    return f"got {given_text(callback)}, which can't be called"
