"""Queries for the actions on the graph, which are methods of nodes from Lyrical on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.ros_imports.ros_distro import warn_if_removed

if TYPE_CHECKING:
    from tfloom.node.base.node_graph import NamesAndTypes
    from tfloom.node.node import Node

__all__ = [
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
]

_FUNCTIONS = "rclpy.action.get_action_names_and_types and its like"


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return all actions that have a server or a client, with their types."""
    warn_if_removed(_FUNCTIONS)
    return node.get_action_names_and_types()


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions that a node serves; RuntimeError if there is no such node."""
    warn_if_removed(_FUNCTIONS)
    return node.get_action_server_names_and_types_by_node(remote_node_name, remote_node_namespace)


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions that a node is a client of; RuntimeError if there is no such node."""
    warn_if_removed(_FUNCTIONS)
    return node.get_action_client_names_and_types_by_node(remote_node_name, remote_node_namespace)
