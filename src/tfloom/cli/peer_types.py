"""Types that have no definition here, from the nodes that use them: by the service `~/get_type_description`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from tfloom.cli import graph
from tfloom.cli.calls import service_client
from tfloom.cli.errors import CommandError
from tfloom.cli.listen import cli_node, shown_node
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription, GetTypeDescription_Response
from tfloom.rmw.base import Graph, NodeName, Participant
from tfloom.rmw.topic_names import type_from_dds
from tfloom.rosidl.described import ANNOUNCED, ANNOUNCED_WITH_SERVICES, DescriptionError, define_described

DISCOVERY_S = 0.5
"""How long to wait at most for discovery [s]."""
CALL_S = 2.0
"""How long to wait for the service of a node, and again for its response [s]."""
MAX_NODES = 3
"""How many nodes are called at most."""


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
    with graph.joined_participant() as joined:
        graph.wait_until_quiet(joined.graph, DISCOVERY_S)
        yield joined


def types_on_graph(found: Graph, kind: str) -> set[str]:
    """Return the types of a kind (msg, srv, action) on the graph."""
    if kind == "msg":
        return {end.topic.type_name for end in found.endpoints()}
    if kind == "srv":
        return {end.type_name for end in found.service_ends()}
    from tfloom.cli.action.common import action_ends

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
    reasons = []
    for node, hashes in list(_users(participant.graph, name, kind).items())[:MAX_NODES]:
        reason = _learn_from(participant, node, name, hashes)
        if not reason:
            return []
        reasons.append(reason)
    return reasons


def _learn_from(participant: Participant, node: NodeName, name: str, hashes: Mapping[str, str]) -> str:
    """Make the classes of a type from a node's description; return why it can't be used, empty after success."""
    try:
        response = _describe(participant, node, name, hashes.get(name, ""))
        if not response.successful:
            return f"{node.full} has no description of it: {response.failure_reason}"
        define_described(name, response.type_description, hashes)
    except CommandError as error:
        return str(error)
    except DescriptionError as error:
        return f"the description from {node.full} can't be used: {error}"
    return ""


def _users(found: Graph, name: str, kind: str) -> dict[NodeName, dict[str, str]]:
    """Return the nodes that announce the hashes of a type, with the hashes of its parts by their names."""
    forms = [{name + suffix for suffix in form[kind]} for form in (ANNOUNCED, ANNOUNCED_WITH_SERVICES)]
    announced: dict[NodeName, dict[str, str]] = {}

    def note(node: NodeName | None, part: str, type_hash: str) -> None:
        if node is not None and type_hash and any(part in form for form in forms):
            announced.setdefault(node, {})[part] = type_hash

    for end in found.raw_endpoints():
        note(end.node, type_from_dds(end.topic.type_name), end.topic.type_hash)
    for service_end in found.service_ends():
        note(service_end.node, service_end.type_name, service_end.type_hash)
    return {node: hashes for node, hashes in announced.items() if hashes.keys() in forms}


def _describe(
    participant: Participant, node: NodeName, name: str, type_hash: str
) -> GetTypeDescription_Response:
    """Return a node's description of a type.

    Args:
        participant: Calls the service.
        node: The node.
        name: `package/kind/Name`.
        type_hash: The announced hash; empty where its parts alone have announced hashes.

    Raises:
        CommandError: the node has no such service, or doesn't respond.
    """
    request = GetTypeDescription.Request(type_name=name, type_hash=type_hash, include_type_sources=False)
    with (
        shown_node(participant, cli_node()) as own,
        service_client(participant, own, f"{node.full}/get_type_description", GetTypeDescription) as client,
    ):
        client.wait_for_server(CALL_S)
        response: GetTypeDescription_Response = client.call(request, CALL_S)
        return response
