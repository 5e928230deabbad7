"""The stay of a node in an executor for the time of one spin."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Protocol

from tfloom.node.values.exceptions import ShutdownException

__all__ = ["TemporarilyAdded"]


class Home(Protocol):
    """The methods of an executor that are used here."""

    def add_node(self, node: Any) -> bool:
        """Add a node; False if it was added before."""

    def remove_node(self, node: Any) -> None:
        """Remove a node."""

    def get_nodes(self) -> list[Any]:
        """Return the nodes that were added."""


class Guest(Protocol):
    """The property of a node that is used here."""

    @property
    def executor(self) -> Home | None:
        """The executor that the node was added to last."""


class TemporarilyAdded:
    """Adds `node` to `executor` for a block, and returns it to its former executor.

    A node that is in `executor` already stays there, because another thread may be spinning it.
    """

    __slots__ = ("_executor", "_former_executor", "_is_new", "_node")

    def __init__(self, node: Guest, executor: Home) -> None:
        self._node = node
        self._executor = executor

    def __enter__(self) -> None:
        # `Node.executor` is also one that the node was removed from.
        former = self._node.executor
        self._former_executor = former if former is not None and self._node in former.get_nodes() else None
        self._is_new = self._executor.add_node(self._node)

    def __exit__(self, *_: object) -> None:
        # A node that was in this executor before stays in it, as one that a callback has moved or destroyed stays away.
        if not self._is_new or self._node not in self._executor.get_nodes():
            return
        self._executor.remove_node(self._node)
        if self._former_executor is not None:
            with suppress(ShutdownException):
                self._former_executor.add_node(self._node)
