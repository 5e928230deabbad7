"""The checks of `doctor` on Zenoh: the router, who reaches a session, and what doesn't pass between sessions."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.rmw.errors import WireError

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, ParticipantInfo, ServiceEndInfo

LINK_TIMEOUT_S = 3.0
WIRE = "rmw_zenoh_cpp"


def is_zenoh_selected() -> bool:
    """Return whether programs of this environment use the wire on Zenoh."""
    from tfloom.rmw.backends import implementation_identifier

    try:
        return implementation_identifier() == WIRE
    except WireError:
        return os.environ.get("RMW_IMPLEMENTATION") == WIRE


def check_router() -> Finding:
    """Check which router a program of this environment is linked to, by which transport, and if it is none, why."""
    from tfloom.rmw.zenoh import config as settings

    names = (
        settings.SESSION_VARIABLE,
        settings.ROUTER_VARIABLE,
        settings.OVERRIDE_VARIABLE,
        settings.CHECKS_VARIABLE,
        settings.PORT_VARIABLE,
        "ROS_AUTOMATIC_DISCOVERY_RANGE",
        "ROS_STATIC_PEERS",
    )
    details: dict[str, Any] = {name: os.environ.get(name, "not set") for name in names}
    try:
        settings.router_checks()
        config = settings.session_configuration()
        endpoints = settings.endpoints_of(config, "connect/endpoints")
        details["mode"], details["connects to"] = settings.mode_of(config), ", ".join(endpoints)
        if not endpoints:
            return Finding(Verdict.OK, "no router is sought", details=details)
        return _linked(config, details)
    except WireError as error:
        return Finding(Verdict.FAILED, str(error), details=details)


def _linked(config: Any, details: dict[str, Any]) -> Finding:
    from contextlib import closing

    from tfloom.rmw.zenoh.config import needs_meeting_point, port, reason_of
    from tfloom.rmw.zenoh.library import open_library
    from tfloom.rmw.zenoh.links import why_no_link, why_no_links
    from tfloom.rmw.zenoh.port_holder import find_port_owner
    from tfloom.rmw.zenoh.session import ZenohSession

    zenoh = open_library()
    is_own = needs_meeting_point(config)
    own = f"tcp/127.0.0.1:{port()}"
    if is_own and "nothing listens" in why_no_link(own, config):
        summary = f"no router at {own} yet: the first program opens one"
        return Finding(Verdict.OK, summary, details=details)
    owner = find_port_owner(port()) if is_own else None
    held = f", held by {owner}" if owner else ""
    try:
        with closing(ZenohSession(zenoh.open(config), config, None)) as opened:
            opened.wait_for_router(LINK_TIMEOUT_S)
            links = opened.router_links()
    except zenoh.ZError as error:
        links = []
        details["error"] = reason_of(error)
    if links:
        details.update(dict(links))
        named = ", ".join(f"{zid} by {endpoint}" for zid, endpoint in links)
        return Finding(Verdict.OK, f"linked to the router {named}{held}", details=details)
    advice = (
        "end that process, or let it go on (fg, kill -CONT)"
        if owner
        else "start a router there, by `tfloom zenoh router`, or correct the endpoint or the certificates"
    )
    return Finding(Verdict.FAILED, f"no link to a router: {why_no_links(config)}{held}", advice, details)


def check_zenoh_reach(details: dict[str, Any]) -> Finding:
    """Check from where a session of Zenoh, with the configuration of the environment, can be reached.

    Raises:
        WireError: the configuration is invalid.
    """
    from tfloom.rmw.zenoh.config import endpoints_of, session_configuration

    endpoints = endpoints_of(session_configuration(), "listen/endpoints")
    details["listens at"] = ", ".join(endpoints) or "nothing"
    local = ("/127.", "/localhost:", "/[::1]:")
    opened = [endpoint for endpoint in endpoints if not any(part in endpoint for part in local)]
    if not opened:
        return Finding(Verdict.OK, "within this machine: sessions listen on loopback alone", details=details)
    if all(endpoint.startswith("tls/") for endpoint in opened):
        return Finding(Verdict.OK, f"sessions listen at {', '.join(opened)}, with TLS", details=details)
    return Finding(
        Verdict.WARNING,
        f"sessions listen at {', '.join(opened)}: any machine that reaches them can read and publish all topics and "
        "call all services, without encryption",
        "use TLS and access rules: see docs/how_to/across_networks.md",
        details,
    )


def check_sessions(
    participants: Iterable[ParticipantInfo],
    endpoints: Iterable[EndpointInfo],
    service_ends: Iterable[ServiceEndInfo],
) -> Finding:
    """Check the other sessions on the domain: nothing passes where one type has two hashes."""
    sessions = [participant for participant in participants if not participant.is_own]
    if not sessions:
        return Finding(Verdict.OK, "no other session on the domain")
    details: dict[str, Any] = {
        f"session {session.gid.hex()}": ", ".join(node.full for node in session.nodes) or "no node"
        for session in sessions
    }
    summary = f"other sessions: {len(sessions)}"
    ends = [(end.topic.name, end.topic.type_name, end.topic.type_hash, end.node) for end in endpoints]
    ends += [(end.name, end.type_name, end.type_hash, end.node) for end in service_ends]
    users: dict[tuple[str, str], dict[str, set[str]]] = {}
    for name, type_name, type_hash, node in ends:
        if type_hash and node is not None:
            users.setdefault((name, type_name), {}).setdefault(type_hash, set()).add(node.full)
    differing = {key: by_hash for key, by_hash in users.items() if len(by_hash) > 1}
    if not differing:
        return Finding(Verdict.OK, f"{summary}; topics and services pass", details=details)
    for (name, type_name), by_hash in sorted(differing.items()):
        details[f"{name} {type_name}"] = "; ".join(
            f"{type_hash} of {', '.join(sorted(nodes))}" for type_hash, nodes in sorted(by_hash.items())
        )
    named = ", ".join(f"{name} ({type_name})" for name, type_name in sorted(differing))
    return Finding(
        Verdict.WARNING,
        f"{summary}; definitions differ, so that nothing passes between some nodes, on {named}",
        "build these packages anew from the same definitions on both sides; --report lists the nodes of each",
        details,
    )
