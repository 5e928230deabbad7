"""The functions of `ros2action.api`: actions on the graph, their servers and their clients."""

from __future__ import annotations

from typing import Any

from tfloom.cli.api.answers import argument_key
from tfloom.cli.api.nodes import GraphNode, NodeStrategy, node_of
from tfloom.cli.shared.names import full_name
from tfloom.rosidl.runtime import get_action
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.workspace.interfaces import known_interfaces

__all__ = [
    "ActionGoalPrototypeCompleter",
    "ActionTypeCompleter",
    "action_name_completer",
    "action_type_completer",
    "get_action_clients_and_servers",
    "get_action_names",
    "get_action_names_and_types",
]

NamesAndTypes = list[tuple[str, list[str]]]


def get_action_clients_and_servers(
    *, node: GraphNode, action_name: str
) -> tuple[NamesAndTypes, NamesAndTypes]:
    """Return the nodes that are clients of an action, and those that serve it, each with the types it uses."""
    asker, name = node_of(node), full_name(action_name)
    clients: NamesAndTypes = []
    servers: NamesAndTypes = []
    for node_name, namespace in dict.fromkeys(asker.get_node_names_and_namespaces()):
        full = f"{namespace.rstrip('/')}/{node_name}"
        try:
            used = asker.get_action_client_names_and_types_by_node(node_name, namespace)
            served = asker.get_action_server_names_and_types_by_node(node_name, namespace)
        except RuntimeError:  # the node has left the graph
            continue
        clients += [(full, types) for action, types in used if action == name]
        servers += [(full, types) for action, types in served if action == name]
    return clients, servers


def get_action_names_and_types(*, node: GraphNode) -> NamesAndTypes:
    """Return the actions on the graph, with their types."""
    return node_of(node).get_action_names_and_types()


def get_action_names(*, node: GraphNode) -> list[str]:
    """Return the names of the actions on the graph."""
    return [name for name, _ in get_action_names_and_types(node=node)]


def action_name_completer(prefix: str, parsed_args: Any, **_: Any) -> list[str]:
    """Return the names of the actions on the graph."""
    with NodeStrategy(parsed_args) as node:
        return get_action_names(node=node)


def action_type_completer(**_: Any) -> list[str]:
    """Return all action types."""
    return known_interfaces("action")


class ActionTypeCompleter:
    """Lists the types of an action on the graph; without one, all action types.

    Args:
        action_name_key: The argument with the action's name.
    """

    def __init__(self, *, action_name_key: str | None = None) -> None:
        self.action_name_key = argument_key(action_name_key, "action_name")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with NodeStrategy(parsed_args) as node:
            actions = dict(get_action_names_and_types(node=node))
        return actions.get(full_name(getattr(parsed_args, self.action_name_key))) or action_type_completer()


class ActionGoalPrototypeCompleter:
    """Lists the one value that a goal starts as, as YAML.

    Args:
        action_type_key: The argument with the action's type.
    """

    def __init__(self, *, action_type_key: str | None = None) -> None:
        self.action_type_key = argument_key(action_type_key, "action_type")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return a goal with its defaults."""
        return [message_to_yaml(get_action(getattr(parsed_args, self.action_type_key)).Goal())]
