"""Cyclone's XML for how far ROS programs look for one another.

ROS_AUTOMATIC_DISCOVERY_RANGE: LOCALHOST (ours where it isn't set), SUBNET, OFF or SYSTEM_DEFAULT.
ROS_STATIC_PEERS: hosts to look at besides, separated by semicolons. A CYCLONEDDS_URI outweighs both.
"""

from __future__ import annotations

import os

from tfloom.rmw.errors import ConfigurationError

RANGES = ("LOCALHOST", "SUBNET", "OFF", "SYSTEM_DEFAULT")
DEFAULT_RANGE = "LOCALHOST"
LOCAL_PARTICIPANTS = 60
"""How many programs find one another on one machine, where each has to be looked for at a port of its own."""

_LOOPBACK = ("127.0.0.1", "localhost", "::1")


def configuration() -> str:
    """Return the configuration that the environment asks for.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`.
    """
    if uri := os.environ.get("CYCLONEDDS_URI"):
        return uri
    asked = os.environ.get("ROS_AUTOMATIC_DISCOVERY_RANGE") or DEFAULT_RANGE
    if os.environ.get("ROS_LOCALHOST_ONLY") == "1":
        asked = "LOCALHOST"
    if asked not in RANGES:
        raise ConfigurationError(
            f"ROS_AUTOMATIC_DISCOVERY_RANGE is {asked!r}, which is none of: {', '.join(RANGES)}"
        )
    peers = [peer.strip() for peer in os.environ.get("ROS_STATIC_PEERS", "").split(";") if peer.strip()]
    return configuration_for(asked, peers)


def configuration_for(discovery_range: str, static_peers: list[str]) -> str:
    """Return the configuration of one of `RANGES`; OFF ignores the peers."""
    if discovery_range == "OFF":
        return _domain(
            _interfaces(_loopback_interface()) + "<AllowMulticast>false</AllowMulticast>",
            f"<ParticipantIndex>none</ParticipantIndex><Tag>tfloom-off-{os.getpid()}</Tag>",
        )
    if discovery_range == "LOCALHOST":
        interfaces = [_loopback_interface()]
        if any(peer not in _LOOPBACK for peer in static_peers):
            interfaces.append('<NetworkInterface autodetermine="true" multicast="false"/>')
        general = _interfaces(*interfaces) + "<AllowMulticast>false</AllowMulticast>"
        return _domain(general, _peers(["127.0.0.1", *static_peers]))
    general = "<AllowMulticast>true</AllowMulticast>" if discovery_range == "SUBNET" else ""
    return _domain(general, _peers(static_peers) if static_peers else "")


def _loopback_interface() -> str:
    return '<NetworkInterface address="127.0.0.1" multicast="false"/>'


def _interfaces(*interfaces: str) -> str:
    return f"<Interfaces>{''.join(interfaces)}</Interfaces>"


def _peers(addresses: list[str]) -> str:
    """Look at these hosts, at the port of each index that a program can have."""
    peers = "".join(f'<Peer address="{_escaped(address)}"/>' for address in dict.fromkeys(addresses))
    return (
        "<ParticipantIndex>auto</ParticipantIndex>"
        f"<MaxAutoParticipantIndex>{LOCAL_PARTICIPANTS}</MaxAutoParticipantIndex>"
        f"<Peers>{peers}</Peers>"
    )


def _domain(general: str, discovery: str) -> str:
    return (
        "<CycloneDDS><Domain>"
        f"<General>{general}</General><Discovery>{discovery}</Discovery>"
        "</Domain></CycloneDDS>"
    )


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
