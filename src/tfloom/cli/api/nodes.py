"""Nodes of commands, for plug-ins and programs: on the graph for a block, which begins when discovery is complete.

There is no daemon, so the functions about it answer that none runs.
"""

from __future__ import annotations

import argparse
import os
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeAlias

from tfloom.cli.shared.graph import MAX_WAIT_S, add_spin_time, wait_until_quiet
from tfloom.node.client_library import init
from tfloom.node.context.utilities import ok, try_shutdown
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = [
    "DEFAULT_TIMEOUT",
    "DirectNode",
    "GraphNode",
    "NodeStrategy",
    "add_daemon_arguments",
    "add_node_arguments",
    "add_strategy_arguments",
    "is_daemon_running",
    "node_of",
    "shutdown_daemon",
    "spawn_daemon",
]

HIDDEN_NODE_PREFIX = "_"
"""Nodes whose names begin with it are hidden."""
NODE_NAME_PREFIX = "_ros2cli"
"""The names of nodes that a command creates begin with it."""


DEFAULT_TIMEOUT = 0.5
"""The reference's time for discovery [s]. Here discovery ends when nothing new arrives; see `wait_until_quiet`."""


class DirectNode(Node):
    """A node that is created with its context, and destroyed with it at the end of a `with`.

    The constructor returns when discovery is complete. If the default context is in use already, as in a program that
    has its own nodes, the node joins it, and leaves it running.

    Args:
        args: What the command line said; its optional attributes `spin_time` (longest time of discovery [s]),
            `use_sim_time`, `argv` (ROS arguments), `start_parameter_services` and `node_name_suffix` count.
        node_name: Name of the node; by default a hidden one with the process's number.
    """

    def __init__(self, args: Any, *, node_name: str | None = None) -> None:
        self._is_context_own = not ok()
        if self._is_context_own:
            init(args=getattr(args, "argv", []))
        suffix = getattr(args, "node_name_suffix", f"_{os.getpid()}")
        use_sim_time = getattr(args, "use_sim_time", False)
        try:
            super().__init__(
                node_name or NODE_NAME_PREFIX + suffix,
                start_parameter_services=getattr(args, "start_parameter_services", False),
                parameter_overrides=[Parameter("use_sim_time", value=use_sim_time)],
                automatically_declare_parameters_from_overrides=True,
            )
        except BaseException:
            self._leave_context()
            raise
        participant = self.context.participant
        if participant is not None:
            wait_until_quiet(participant.graph, getattr(args, "spin_time", MAX_WAIT_S))

    @property
    def node(self) -> Self:
        """The node itself, which the reference's class holds in an attribute."""
        return self

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.destroy_node()
        self._leave_context()

    def _leave_context(self) -> None:
        if self._is_context_own:
            try_shutdown()


def add_node_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags that `DirectNode` reads."""
    add_spin_time(parser)
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="use the time on /clock")


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


def add_strategy_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags that `NodeStrategy` reads."""
    add_node_arguments(parser)
    add_daemon_arguments(parser)


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
