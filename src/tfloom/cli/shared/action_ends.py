"""Actions on the graph, by the servers and clients of `<action>/_action/send_goal`."""

from __future__ import annotations

from typing import NamedTuple

from tfloom.cli.shared import graph
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.rmw.base import Graph
from tfloom.rmw.shared.endpoint_text import UNKNOWN_NODE
from tfloom.rmw.typed_names import SEND_GOAL, SEND_GOAL_TYPE


class ActionEnd(NamedTuple):
    """A server or a client of an action."""

    name: str
    type_name: str
    node: str
    is_server: bool


def action_ends(found: Graph) -> list[ActionEnd]:
    """Return the servers and clients of all actions, in order of the actions' names, then the nodes'."""
    return sorted(
        ActionEnd(
            end.name.removesuffix(SEND_GOAL),
            end.type_name.removesuffix(SEND_GOAL_TYPE),
            end.node.full if end.node else UNKNOWN_NODE.name,
            end.is_server,
        )
        for end in found.service_ends()
        if end.name.endswith(SEND_GOAL)
    )


def settled_ends() -> list[ActionEnd]:
    """Join the domain, wait until discovery is complete, and return the actions' servers and clients."""
    with graph.settled_graph(graph.MAX_WAIT_S) as found:
        return action_ends(found)


def ends_of_action(name: str) -> tuple[str, list[ActionEnd], str]:
    """Return an action's full name, its servers and its clients, and what to say if it has none.

    Raises:
        CommandError: it is not a valid name.
    """
    full = full_topic_name(name, "action")
    everything = settled_ends()
    ends = [end for end in everything if end.name == full]
    near = did_you_mean(full, {end.name for end in everything})
    return full, ends, "" if ends else f"Unknown action '{full}'{near}"
