"""Types that have no definition here, searched for on the graph by a command."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from tfloom.cli.shared import graph
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.rmw.base import Graph, Participant
from tfloom.rmw.shared import peer_types

DISCOVERY_S = 0.5
"""How long to wait at most for discovery [s]."""


@contextmanager
def searched_participant(participant: Participant | None) -> Iterator[Participant]:
    """Yield a participant whose discovery is complete: the given one, or one that joins the domain for the block.

    Raises:
        WireError: the domain can't be joined.
    """
    if participant is not None:
        graph.wait_until_quiet(participant.graph, DISCOVERY_S)
        yield participant
        return
    with graph.settled_participant(DISCOVERY_S) as joined:
        yield joined


def types_on_graph(found: Graph, kind: str) -> set[str]:
    """Return the types of a kind (msg, srv, action) on the graph."""
    if kind == "msg":
        return {end.topic.type_name for end in found.endpoints()}
    if kind == "srv":
        return {end.type_name for end in found.service_ends()}
    from tfloom.cli.shared.action_ends import action_ends

    return {end.type_name for end in action_ends(found)}


def learn(participant: Participant, name: str, kind: str) -> list[str]:
    """Make the classes of a type from the description of a node that uses it.

    Args:
        participant: Its discovery is complete.
        name: `package/kind/Name`.
        kind: msg, srv or action.

    Returns:
        Why the descriptions of nodes can't be used: empty after success, and where no node uses the type.
    """
    if not peer_types.users(participant.graph, name, kind):
        return []
    with shown_node(participant, cli_node()) as own_node:
        return peer_types.learn(participant, own_node, name, kind)
