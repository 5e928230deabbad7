"""The functions of `ros2lifecycle.api`: lifecycle nodes, their states and transitions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from tfloom.cli.api.answers import TIMEOUT_S, Call, call_services
from tfloom.cli.api.node import NodeName, parse_node_name
from tfloom.cli.api.nodes import GraphNode
from tfloom.cli.shared.names import full_name
from tfloom.interfaces.lifecycle_msgs.msg import State, Transition, TransitionDescription
from tfloom.interfaces.lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from tfloom.node.values.names import topic_or_service_is_hidden

__all__ = [
    "call_change_states",
    "call_get_available_transitions",
    "call_get_states",
    "call_get_transition_graph",
    "get_node_names",
]

_STATE_SERVICE = "/get_state"


def get_node_names(*, node: GraphNode, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the names of the nodes that have a lifecycle: those with a service `get_state` of its type."""
    services: list[tuple[str, list[str]]] = node.get_service_names_and_types()
    names = [
        name.removesuffix(_STATE_SERVICE)
        for name, types in services
        if name.endswith(_STATE_SERVICE) and "lifecycle_msgs/srv/GetState" in types
    ]
    return [
        parse_node_name(name)
        for name in names
        if include_hidden_nodes or not topic_or_service_is_hidden(name)
    ]


def call_get_states(
    *, node: GraphNode, node_names: Iterable[str], timeout: float | None = TIMEOUT_S
) -> dict[str, State | Exception]:
    """Return the state of each node, or the error of asking it.

    Args:
        node: What asks.
        node_names: Full names of lifecycle nodes.
        timeout: Longest wait for the services and for their responses, each [s].
    """
    calls = {name: Call(GetState, f"{full_name(name)}/get_state", GetState.Request()) for name in node_names}
    return _each(call_services(node, calls, timeout), "current_state")


def call_get_available_transitions(
    *, node: GraphNode, states: Mapping[str, Any], timeout: float | None = TIMEOUT_S
) -> dict[str, list[TransitionDescription] | Exception]:
    """Return the transitions that are available in each node's present state, or the error of asking it.

    Args:
        node: What asks.
        states: Has the full names of lifecycle nodes as its keys; its values don't count.
        timeout: Longest wait for the services and for their responses, each [s].
    """
    return _transitions(node, states, "get_available_transitions", timeout)


def call_get_transition_graph(
    *, node: GraphNode, states: Mapping[str, Any], timeout: float | None = TIMEOUT_S
) -> dict[str, list[TransitionDescription] | Exception]:
    """Return all transitions of each node, or the error of asking it; see `call_get_available_transitions`."""
    return _transitions(node, states, "get_transition_graph", timeout)


def _transitions(
    node: GraphNode, states: Mapping[str, Any], service: str, timeout: float | None
) -> dict[str, list[TransitionDescription] | Exception]:
    calls = {
        name: Call(GetAvailableTransitions, f"{full_name(name)}/{service}", GetAvailableTransitions.Request())
        for name in states
    }
    return _each(call_services(node, calls, timeout), "available_transitions")


def call_change_states(
    *, node: GraphNode, transitions: Mapping[str, Transition], timeout: float | None = TIMEOUT_S
) -> dict[str, bool | Exception]:
    """Request a transition of each node; return whether it succeeded, or the error of asking for it.

    Args:
        node: What asks.
        transitions: The transition of each node, by the node's full name.
        timeout: Longest wait for the services and for their responses, each [s].
    """
    calls = {
        name: Call(ChangeState, f"{full_name(name)}/change_state", ChangeState.Request(transition=transition))
        for name, transition in transitions.items()
    }
    return _each(call_services(node, calls, timeout), "success")


def _each(answers: Mapping[str, Any], field: str) -> dict[str, Any]:
    """Return a field of each response; an error stays."""
    return {
        name: answer if isinstance(answer, Exception) else getattr(answer, field)
        for name, answer in answers.items()
    }
