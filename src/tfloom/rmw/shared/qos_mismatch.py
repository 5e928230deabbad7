"""The warning about a writer and a reader that don't connect because of their qualities of service."""

from __future__ import annotations

from tfloom.common.terminal import shown_part
from tfloom.rmw.base import EndpointInfo, Graph
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.events import IncompatibleQoS
from tfloom.rmw.qos import INFINITE_NS, QoS, QoSPolicyKind

MAX_DIFFERENCES = 5
"""How many differences of a topic's endpoints a warning has."""


def mismatch_text(
    status: IncompatibleQoS, topic_name: str, gid: bytes, graph: Graph, *, is_publisher: bool
) -> str:
    """Return the warning of a publisher or subscription, with the policies of both sides.

    Args:
        status: The status of the event.
        topic_name: Fully qualified name of the topic.
        gid: 16 bytes of the endpoint that warns.
        graph: The graph to look up the other endpoints in.
        is_publisher: Whether the endpoint that warns is the publisher.
    """
    peer, verb, consequence = (
        ("subscription", "requesting", "No messages will be sent to it")
        if is_publisher
        else ("publisher", "offering", "No messages will be received from it")
    )
    if graph.delivers_incompatible():
        consequence = "Messages pass all the same on this wire, but don't on others"
    policy = QoSPolicyKind(status.last_policy_kind).name
    return (
        f"New {peer} discovered on topic '{topic_name}', {verb} incompatible QoS. {consequence}. "
        f"Last incompatible policy: {policy}{_both_sides(topic_name, gid, graph, is_publisher)}"
    )


def _both_sides(topic_name: str, gid: bytes, graph: Graph, is_publisher: bool) -> str:
    ends = [info for info in graph.endpoints() if info.topic.name == topic_name]
    mine = next((info for info in ends if info.gid == gid), None)
    peers = [info for info in ends if info.is_writer != is_publisher]
    texts = [text for peer in peers for text in _differences(mine, peer, is_publisher)] if mine else []
    if (more := len(texts) - MAX_DIFFERENCES) > 0:
        texts[MAX_DIFFERENCES:] = [f"and {more} more"]
    return f" ({'; '.join(texts)})" if texts else ""


def _differences(mine: EndpointInfo, peer: EndpointInfo, is_publisher: bool) -> list[str]:
    writer, reader = (mine, peer) if is_publisher else (peer, mine)
    whose = "an unknown node" if peer.node is None else shown_part(peer.node.full)
    return [f"{text}, peer {whose}" for text in differences(writer.qos, reader.qos)]


def differences(offered: QoS, requested: QoS) -> list[str]:
    """Return what is offered and what is requested of each policy that keeps them apart; empty if none does."""
    return [
        f"offered {_show(offered, requested, kind.name)}, requested {_show(requested, offered, kind.name)}"
        for kind in incompatible_policies(offered, requested)
    ]


def _show(qos: QoS, other: QoS, policy: str) -> str:
    """Return a policy of one endpoint, with its difference from the other's."""
    if policy == "DEADLINE":
        return f"DEADLINE of {_seconds(qos.deadline_ns)}" if qos.deadline_ns < INFINITE_NS else "no DEADLINE"
    text = f"{policy} {getattr(qos, policy.lower()).name}"
    if policy == "LIVELINESS" and qos.liveliness == other.liveliness:
        lease_ns = qos.liveliness_lease_ns
        return text + (
            f" with a lease of {_seconds(lease_ns)}" if lease_ns < INFINITE_NS else " with no lease"
        )
    return text


def _seconds(nanoseconds: int) -> str:
    return f"{nanoseconds / 1e9:g} s"
