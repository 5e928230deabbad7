"""Cyclone's XML configuration for the range of discovery.

ROS_AUTOMATIC_DISCOVERY_RANGE: LOCALHOST (tfloom's default), SUBNET, OFF or SYSTEM_DEFAULT.
ROS_STATIC_PEERS: further hosts to search, separated by semicolons. A CYCLONEDDS_URI takes precedence over both.
"""

from __future__ import annotations

import os
import sys

from tfloom.rmw.errors import ConfigurationError

RANGES = ("LOCALHOST", "SUBNET", "OFF", "SYSTEM_DEFAULT")
DEFAULT_RANGE = "LOCALHOST"
LOCAL_PARTICIPANTS = 60
"""Most programs that can discover one another on one machine, because each is searched at its own port."""

_LOOPBACK = ("127.0.0.1", "localhost", "::1")

# Linux's loopback interface transfers 64 KiB in one packet, which halves the cost of a message of 1 MB.
_LARGE_DATAGRAMS = "<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>65000B</FragmentSize>"
# A message of 5 MB at best effort arrives in one burst; the system may limit the buffer to less.
_RECEIVE_BUFFER = '<SocketReceiveBufferSize max="4MB"/>'
# A closing writer waits until its last samples are acknowledged, and requests this with this period. Cyclone's default
# of 100 ms is for networks; on one machine it would delay the end of each program by 0.2 s.
_PROMPT_ACKNOWLEDGEMENTS = "<HeartbeatInterval>20ms</HeartbeatInterval>"


def configuration() -> str:
    """Return the configuration for the environment.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`.
    """
    return os.environ.get("CYCLONEDDS_URI") or configuration_for(discovery_range(), _static_peers())


def discovery_range() -> str:
    """Return the range, one of `RANGES`, that the environment selects.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of them.
    """
    asked = os.environ.get("ROS_AUTOMATIC_DISCOVERY_RANGE") or DEFAULT_RANGE
    if os.environ.get("ROS_LOCALHOST_ONLY") == "1":
        asked = "LOCALHOST"
    if asked not in RANGES:
        raise ConfigurationError(
            f"ROS_AUTOMATIC_DISCOVERY_RANGE is {asked!r}, which is none of: {', '.join(RANGES)}"
        )
    return asked


def look_up_peers() -> None:
    """Resolve the hosts of ROS_STATIC_PEERS, because an unknown one makes Cyclone abort the process.

    Raises:
        ConfigurationError: one can't be resolved.
    """
    import socket

    if os.environ.get("CYCLONEDDS_URI"):
        return
    for peer in _static_peers():
        host, _, port = peer.rpartition(":") if peer.count(":") == 1 else (peer, "", "0")
        try:
            socket.getaddrinfo(host, int(port), socket.AF_INET)
        except (OSError, ValueError, OverflowError) as error:
            raise ConfigurationError(f"ROS_STATIC_PEERS names {peer!r}, which is no host: {error}") from None


def _static_peers() -> list[str]:
    return [peer.strip() for peer in os.environ.get("ROS_STATIC_PEERS", "").split(";") if peer.strip()]


def configuration_for(asked: str, static_peers: list[str]) -> str:
    """Return the configuration of one of `RANGES`; OFF ignores the peers."""
    others = [peer for peer in static_peers if peer not in _LOOPBACK]
    if asked == "OFF":
        tag = f"<ParticipantIndex>none</ParticipantIndex><Tag>tfloom-off-{os.getpid()}</Tag>"
        return _domain(_loopback(), tag, _RECEIVE_BUFFER + _PROMPT_ACKNOWLEDGEMENTS)
    if asked == "LOCALHOST":
        internal = _RECEIVE_BUFFER if others else _RECEIVE_BUFFER + _PROMPT_ACKNOWLEDGEMENTS
        return _domain(_loopback(reach_others=bool(others)), _peers(["127.0.0.1", *others]), internal)
    discovery = _peers(static_peers) if static_peers else ""
    if asked == "SUBNET":
        return _domain("<AllowMulticast>true</AllowMulticast>", discovery, _RECEIVE_BUFFER)
    return _domain("", discovery, "")


def _loopback(*, reach_others: bool = False) -> str:
    """Use unicast on the loopback interface, and for other machines the interface that Cyclone selects."""
    interfaces = '<NetworkInterface address="127.0.0.1" multicast="false"/>'
    if reach_others:
        interfaces += '<NetworkInterface autodetermine="true" multicast="false"/>'
    datagrams = _LARGE_DATAGRAMS if sys.platform == "linux" and not reach_others else ""
    return f"<Interfaces>{interfaces}</Interfaces><AllowMulticast>false</AllowMulticast>{datagrams}"


def _peers(addresses: list[str]) -> str:
    """Search these hosts, at the port of each participant index."""
    peers = "".join(f'<Peer address="{_escaped(address)}"/>' for address in dict.fromkeys(addresses))
    return (
        "<ParticipantIndex>auto</ParticipantIndex>"
        f"<MaxAutoParticipantIndex>{LOCAL_PARTICIPANTS}</MaxAutoParticipantIndex>"
        f"<Peers>{peers}</Peers>"
    )


def _domain(general: str, discovery: str, internal: str) -> str:
    return (
        f"<CycloneDDS><Domain><General>{general}</General><Discovery>{discovery}</Discovery>"
        f"<Internal>{internal}</Internal></Domain></CycloneDDS>"
    )


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
