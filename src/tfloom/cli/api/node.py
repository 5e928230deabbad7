"""The functions of `ros2node.api`: nodes on the graph, and what each has."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from tfloom.cli.api.answers import argument_key
from tfloom.cli.api.nodes import HIDDEN_NODE_PREFIX, GraphNode, NodeStrategy, node_of
from tfloom.cli.plugins.helpers import wait_for
from tfloom.cli.shared.names import full_name
from tfloom.node.values.names import topic_or_service_is_hidden

__all__ = [
    "INFO_NONUNIQUE_WARNING_TEMPLATE",
    "NodeName",
    "NodeNameCompleter",
    "TopicInfo",
    "get_absolute_node_name",
    "get_action_client_info",
    "get_action_server_info",
    "get_node_names",
    "get_publisher_info",
    "get_service_client_info",
    "get_service_server_info",
    "get_subscriber_info",
    "get_topics",
    "has_duplicates",
    "parse_node_name",
    "wait_for_node",
]

INFO_NONUNIQUE_WARNING_TEMPLATE = (
    'There are {num_nodes} nodes in the graph with the exact name "{node_name}". '
    "You are seeing information about only one of them."
)


class NodeName(NamedTuple):
    """The name of a node."""

    name: str
    namespace: str
    full_name: str


class TopicInfo(NamedTuple):
    """A topic, service or action, with its types."""

    name: str
    types: list[str]


def get_absolute_node_name(node_name: str | None) -> str | None:
    """Return a node's name with its first slash; None for no name."""
    return full_name(node_name) if node_name else None


def parse_node_name(node_name: str) -> NodeName:
    """Return name, namespace and full name of a node, whose first slash may be left out."""
    full = full_name(node_name)
    namespace, _, name = full.rpartition("/")
    return NodeName(name, namespace or "/", full)


def has_duplicates(values: Iterable[Any]) -> bool:
    """Return whether a value occurs more than once."""
    listed = list(values)
    return len(set(listed)) < len(listed)


def get_node_names(*, node: GraphNode, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the names of the nodes on the graph."""
    names: list[tuple[str, str]] = node.get_node_names_and_namespaces()
    return [
        NodeName(name, namespace, f"{namespace.rstrip('/')}/{name}")
        for name, namespace in names
        if include_hidden_nodes or not (name and name.startswith(HIDDEN_NODE_PREFIX))
    ]


def get_topics(
    remote_node_name: str, func: Callable[[str, str], list[tuple[str, list[str]]]]
) -> list[TopicInfo]:
    """Return what the graph has of a node.

    Args:
        remote_node_name: The node's name.
        func: The query, as a node's `get_publisher_names_and_types_by_node`; it takes name and namespace.
    """
    remote = parse_node_name(remote_node_name)
    return [TopicInfo(name, types) for name, types in func(remote.name, remote.namespace)]


def get_subscriber_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the topics that a node subscribes to; RuntimeError if there is no such node."""
    return _shown(get_topics(remote_node_name, node.get_subscriber_names_and_types_by_node), include_hidden)


def get_publisher_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the topics that a node publishes; RuntimeError if there is no such node."""
    return _shown(get_topics(remote_node_name, node.get_publisher_names_and_types_by_node), include_hidden)


def get_service_client_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the services that a node is a client of; RuntimeError if there is no such node."""
    return _shown(get_topics(remote_node_name, node.get_client_names_and_types_by_node), include_hidden)


def get_service_server_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the services that a node serves; RuntimeError if there is no such node."""
    return _shown(get_topics(remote_node_name, node.get_service_names_and_types_by_node), include_hidden)


def get_action_server_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the actions that a node serves; RuntimeError if there is no such node."""
    query = node_of(node).get_action_server_names_and_types_by_node
    return _shown(get_topics(remote_node_name, query), include_hidden)


def get_action_client_info(
    *, node: GraphNode, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the actions that a node is a client of; RuntimeError if there is no such node."""
    query = node_of(node).get_action_client_names_and_types_by_node
    return _shown(get_topics(remote_node_name, query), include_hidden)


def _shown(topics: list[TopicInfo], include_hidden: bool) -> list[TopicInfo]:
    return [topic for topic in topics if include_hidden or not topic_or_service_is_hidden(topic.name)]


def wait_for_node(node: GraphNode, include_hidden_nodes: bool, node_name: str, timeout: float) -> bool:
    """Wait until a node is on the graph; return whether it is after `timeout` [s]."""

    def is_there() -> bool:
        names = get_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
        return node_name in {name.full_name for name in names}

    return wait_for(is_there, timeout)


class NodeNameCompleter:
    """Lists the nodes on the graph.

    Args:
        include_hidden_nodes_key: The argument that says whether hidden ones are listed.
    """

    def __init__(self, *, include_hidden_nodes_key: str | None = None) -> None:
        self.include_hidden_nodes_key = include_hidden_nodes_key

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return their full names."""
        key = argument_key(self.include_hidden_nodes_key, "include_hidden_nodes")
        with NodeStrategy(parsed_args) as node:
            names = get_node_names(node=node, include_hidden_nodes=getattr(parsed_args, key, False))
        return [name.full_name for name in names]
