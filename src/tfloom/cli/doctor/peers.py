"""The checks of `doctor` on the other participants of the domain.

One is on vendor and version of their DDS, and what passes; one on qualities of service: which publishers and
subscriptions of a topic don't connect; one lists services and actions. They share what one participant has discovered,
because discovery takes longer than the checks.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.cli.doctor.zenoh import check_sessions, is_zenoh_selected
from tfloom.rmw.base import PREFIX_LENGTH, EndpointInfo, ParticipantInfo, ServiceEndInfo
from tfloom.rmw.errors import WireError
from tfloom.rmw.typed_names import SEND_GOAL

DISCOVERY_TIMEOUT_S = 5.0
"""The longest wait for the nodes and endpoints of other participants [s]."""

VENDORS = {
    b"\x01\x01": "RTI Connext",
    b"\x01\x02": "OpenSplice",
    b"\x01\x03": "OpenDDS",
    b"\x01\x0f": "Fast DDS",
    b"\x01\x10": "Cyclone DDS",
    b"\x01\x11": "GurumDDS",
    b"\x01\x12": "RustDDS",
}
"""Vendors by the first bytes of their participants' gids (RTPS's vendor ids)."""
MAX_PAIRS = 20
"""Pairs that are named, because a topic may have hundreds."""
MAX_NAMES = 5
"""Services that are named in one line."""


class Domain(NamedTuple):
    """What a participant that joined the domain has discovered."""

    participants: list[ParticipantInfo]
    """Its own, too."""
    endpoints: list[EndpointInfo]
    service_ends: list[ServiceEndInfo]
    delivers_incompatible: bool
    """Whether the wire delivers messages between endpoints whose qualities of service do not match."""


class SharedDomain:
    """The domain of ROS_DOMAIN_ID, joined when the first check needs it; the other checks get the same contents."""

    @cached_property
    def contents(self) -> Domain:
        """What has been discovered.

        Raises:
            WireError: the wire can't be opened.
        """
        from tfloom._native import dds_read_versions
        from tfloom.cli.shared.graph import settled_graph

        if not is_zenoh_selected():
            dds_read_versions()
        with settled_graph(DISCOVERY_TIMEOUT_S) as graph:
            return Domain(
                list(graph.participants()),
                list(graph.endpoints()),
                list(graph.service_ends()),
                graph.delivers_incompatible(),
            )


def check_peers(shared: SharedDomain) -> Finding:
    """Check what passes between this process and each participant on the domain: on DDS, by its vendor."""
    from tfloom.rmw.cyclone.library import open_library
    from tfloom.rmw.cyclone.services import start_translation

    try:
        domain = shared.contents
        if domain.participants[0].gid.startswith(b"tfloom::"):
            return Finding(Verdict.OK, "none: tfloom_local connects the nodes of one process")
        if is_zenoh_selected():
            return check_sessions(domain.participants, domain.endpoints, domain.service_ends)
        failure = start_translation(open_library().path)
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))
    peers = [peer for peer in domain.participants if not peer.is_own]
    if not peers:
        return Finding(Verdict.OK, "no other participant on the domain")
    counts: dict[str, int] = {}
    details: dict[str, str] = {}
    refused: list[str] = []
    for gid, nodes, _ in peers:
        product = product_of(gid)
        counts[product] = counts.get(product, 0) + 1
        names = ", ".join(node.full for node in nodes) or "no node"
        passes, do_services = what_passes(gid, failure)
        if not do_services:
            refused.append(names)
        details[f"participant {gid[:PREFIX_LENGTH].hex()}"] = f"{product} ({names}); services: {passes}"
    summary = "other participants: " + ", ".join(f"{count} on {product}" for product, count in counts.items())
    if not refused:
        return Finding(Verdict.OK, f"{summary}; topics and services pass", details=details)
    return Finding(
        Verdict.WARNING,
        f"{summary}; no services with {', '.join(refused)}",
        "start these with RMW_IMPLEMENTATION=rmw_cyclonedds_cpp; a client there waits without an answer",
        details,
    )


def product_of(gid: bytes) -> str:
    """Return the vendor of a participant's DDS and the version that it announces."""
    from tfloom._native import dds_version

    vendor = VENDORS.get(gid[:2], f"vendor {gid[:2].hex()}")
    return f"{vendor} {dds_version(gid) or 'of unknown version'}"


def what_passes(gid: bytes, untranslated: str) -> tuple[str, bool]:
    """Return the form of a participant's services in words, with what passes, and whether services do.

    Args:
        gid: The participant's.
        untranslated: Why services of Fast DDS are not translated; empty if they are.
    """
    from tfloom.rmw.cyclone.graph import FAST_DDS
    from tfloom.rmw.cyclone.services import CYCLONE_VENDOR

    if gid.startswith(CYCLONE_VENDOR):
        return "header in the message; all passes", True
    if gid.startswith(FAST_DDS) and not untranslated:
        return "inline QoS; all passes, services translated", True
    form = (
        f"inline QoS, not translated because {untranslated}" if gid.startswith(FAST_DDS) else "unknown form"
    )
    return f"{form}; topics pass, services, actions and parameters don't", False


def check_qos(shared: SharedDomain) -> Finding:
    """Check that the publishers of each topic offer what its subscriptions request."""
    try:
        domain = shared.contents
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))
    by_topic: dict[str, tuple[list[EndpointInfo], list[EndpointInfo]]] = {}
    for end in domain.endpoints:
        by_topic.setdefault(end.topic.name, ([], []))[0 if end.is_writer else 1].append(end)
    apart = [
        pair
        for topic, (writers, readers) in sorted(by_topic.items())
        for pair in _apart(topic, writers, readers)
    ]
    if not apart:
        return Finding(
            Verdict.OK, "no publisher and subscription of a topic differ so that they don't connect"
        )
    details = {f"pair {number}": text for number, text in enumerate(apart[:MAX_PAIRS], 1)}
    more = f"; and {len(apart) - 1} more pair{'s' * (len(apart) > 2)}: see --report" if len(apart) > 1 else ""
    if domain.delivers_incompatible:
        verdict, consequence = Verdict.WARNING, "their messages pass on this wire, but don't on others"
    else:
        verdict, consequence = Verdict.FAILED, "no message passes between them"
    advice = "give both the same quality of service, or the subscription the weaker one, as best effort"
    return Finding(verdict, f"{apart[0]}, so {consequence}{more}", advice, details)


def check_services(shared: SharedDomain) -> Finding:
    """List the services and actions of the domain, and name the services whose clients have no server."""
    from tfloom.cli.service.queries import service_types

    try:
        ends = shared.contents.service_ends
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))
    details = {}
    unserved = []
    for name, types in service_types(ends).items():
        servers, clients = (
            sorted(_node(end) for end in ends if end.name == name and end.is_server is is_server)
            for is_server in (True, False)
        )
        if not servers:
            unserved.append(name)
        sides = [
            f"{side} {', '.join(nodes)}"
            for side, nodes in (("servers", servers), ("clients", clients))
            if nodes
        ]
        details[name] = f"{', '.join(types)}; {'; '.join(sides)}"
    action_count = sum(name.endswith(SEND_GOAL) for name in details)
    summary = f"services: {len(details)}, of which {action_count} begin goals of actions"
    if unserved:
        shown = ", ".join(unserved[:MAX_NAMES]) + (", …" if len(unserved) > MAX_NAMES else "")
        summary += f"; clients wait for a server of {shown}"
    return Finding(Verdict.OK, summary, details=details)


def _apart(topic: str, writers: list[EndpointInfo], readers: list[EndpointInfo]) -> Iterator[str]:
    from tfloom.rmw.shared.qos_mismatch import differences

    for writer in writers:
        for reader in readers:
            if texts := differences(writer.qos, reader.qos):
                yield f"{topic}: {_node(writer)} {_node(reader, 'and ')}: {'; '.join(texts)}"


def _node(end: EndpointInfo | ServiceEndInfo, before: str = "") -> str:
    return before + ("an unknown node" if end.node is None else end.node.full)
