"""The node that verbs query the graph with, and the daemon, which is not there."""

from __future__ import annotations

import argparse
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeAlias

from tfloom.cli.nodes import direct
from tfloom.cli.nodes.direct import DirectNode
from tfloom.node.node import Node

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = [
    "GraphNode",
    "NodeStrategy",
    "add_arguments",
    "add_daemon_arguments",
    "is_daemon_running",
    "node_of",
    "shutdown_daemon",
    "spawn_daemon",
]


def add_daemon_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flag for an answer without the daemon, which has no effect."""
    parser.add_argument("--no-daemon", action="store_true", help="accepted and not used: there is no daemon")


def is_daemon_running(args: Any) -> bool:
    """Return whether a daemon runs: False."""
    return False


def spawn_daemon(args: Any, timeout: float | None = None, debug: bool = False) -> bool:
    """Return whether this call started a daemon: False."""
    return False


def shutdown_daemon(args: Any, timeout: float | None = None) -> bool:
    """Return whether this call ended a daemon: False."""
    return False


class NodeStrategy:
    """A node for queries of the graph, created when it is first used.

    In the reference it is a daemon's node or, without a daemon, a `DirectNode`; here it is always the latter.

    Args:
        args: What the command line said; see `DirectNode`.
        node_name: Name of the node; by default a hidden one with the process's number.
    """

    def __init__(self, args: Any, *, node_name: str | None = None) -> None:
        self.args = args
        self.node_name = node_name
        self._direct_node: DirectNode | None = None

    @property
    def daemon_node(self) -> None:
        """The daemon's node: there is none."""
        return

    @property
    def direct_node(self) -> DirectNode:
        """The node that asks the graph itself; created at the first access."""
        if self._direct_node is None:
            self._direct_node = DirectNode(self.args, node_name=self.node_name)
        return self._direct_node

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        node, self._direct_node = self._direct_node, None
        if node is not None:
            node.__exit__(kind, error, traceback)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.direct_node, name)


GraphNode: TypeAlias = Node | NodeStrategy
"""What the functions of `ros2topic.api` and the like take as `node`."""


def node_of(node: GraphNode) -> Node:
    """Return the node itself."""
    return node.direct_node if isinstance(node, NodeStrategy) else node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags that `NodeStrategy` reads."""
    direct.add_arguments(parser)
    add_daemon_arguments(parser)
