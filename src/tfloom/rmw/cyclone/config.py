"""Cyclone's XML configuration for the range of discovery and the lease of participants.

ROS_AUTOMATIC_DISCOVERY_RANGE: LOCALHOST (tfloom's default), SUBNET, OFF or SYSTEM_DEFAULT.
ROS_STATIC_PEERS: further hosts to search, separated by semicolons. As in a stock ROS 2 it has no effect with OFF,
SYSTEM_DEFAULT and ROS_LOCALHOST_ONLY=1.
TFLOOM_LEASE_S: the time after which others remove this process if it ended without leaving [s], from 2; 10 by default.
A CYCLONEDDS_URI takes precedence over all three.
"""

from __future__ import annotations

import math
import os
import sys

from tfloom.rmw.errors import ConfigurationError

RANGES = ("LOCALHOST", "SUBNET", "OFF", "SYSTEM_DEFAULT")
DEFAULT_RANGE = "LOCALHOST"
RANGES_WITHOUT_PEERS = ("OFF", "SYSTEM_DEFAULT")
"""The ranges with which ROS_STATIC_PEERS has no effect."""
LOCAL_PARTICIPANTS = 119
"""Most programs that can discover one another on one machine, because each is searched at its own port.

The next 250 ports belong to the next domain. Of the last domain, fewer ports exist: see `local_participants`.
"""
LEASE_VARIABLE = "TFLOOM_LEASE_S"
LEASE_RANGE_S = (2.0, 3600.0)
"""The shortest and the longest lease [s]. A shorter one would end while a busy machine delays its renewal."""

LAST_PORT = 65535

_LOOPBACK = ("127.0.0.1", "localhost", "::1")

# Linux's loopback interface transfers 64 KiB in one packet, which halves the cost of a message of 1 MB.
_LARGE_DATAGRAMS = "<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>65000B</FragmentSize>"
# A message of 5 MB at best effort arrives in one burst; the system may limit the buffer to less.
_RECEIVE_BUFFER = '<SocketReceiveBufferSize max="4MB"/>'
# Fast DDS recognises a closed endpoint by the hash of its key, which Cyclone omits unless requested. Without it, the
# participants of Fast DDS count each closed writer and reader until the whole process leaves. ROS's topics have no
# keys, so messages do not grow.
_KEY_HASHES = "<GenerateKeyhash>true</GenerateKeyhash>"
# Cyclone's periods are for networks. On one machine: a closing writer waits until its last samples are acknowledged,
# and requests this with the period of the heartbeat (by default 100 ms, which would delay the end of each program by
# 0.2 s); a reader acknowledges a new writer after PreEmptiveAckDelay (10 ms), before which a client isn't ready; it
# requests what it has missed after NackDelay (100 ms).
_PROMPT_ACKNOWLEDGEMENTS = (
    "<HeartbeatInterval>20ms</HeartbeatInterval>"
    "<PreEmptiveAckDelay>1ms</PreEmptiveAckDelay>"
    "<NackDelay>2ms</NackDelay>"
)
# Without a period, Cyclone announces itself to other hosts at its start alone, and so doesn't find those that start
# later and have this host not among their peers. Fast DDS has the same period.
_ANNOUNCE_TO_PEERS_S = 3.0


def configuration(domain_id: int = 0, announce_s: float | None = None, library_version: str = "") -> str:
    """Return the configuration for the environment.

    Args:
        domain_id: The domain, because the last one has fewer ports.
        announce_s: Period at which the searched ports of this machine and of other hosts get an announcement, for as
            long as the participant exists [s]; None: 3 s with other hosts, otherwise Cyclone's. Needed to
            discover those that announce themselves by multicast alone, which the range LOCALHOST does not receive.
        library_version: That of libddsc, because 0.10 refuses settings that it doesn't know; empty: 11.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`, or TFLOOM_LEASE_S is outside
            `LEASE_RANGE_S`.
    """
    return os.environ.get("CYCLONEDDS_URI") or configuration_for(
        discovery_range(), _static_peers(), domain_id, lease_s(), announce_s, library_version
    )


def lease_s() -> float | None:
    """Return the lease that the environment requests [s]; None: Cyclone's, 10 s.

    Raises:
        ConfigurationError: TFLOOM_LEASE_S is not a number, or outside `LEASE_RANGE_S`.
    """
    text = os.environ.get(LEASE_VARIABLE, "").strip()
    if not text:
        return None
    least_s, most_s = LEASE_RANGE_S
    try:
        lease = float(text)
    except ValueError:
        lease = math.nan
    if not least_s <= lease <= most_s:
        raise ConfigurationError(
            f"{LEASE_VARIABLE} is {text!r}, which is not a number of seconds from {least_s:g} to {most_s:g}"
        )
    return lease


def discovery_port(domain_id: int, index: int) -> int:
    """Return the UDP port at which the participant with this index is searched; the next port is that of its data."""
    return 7400 + 250 * domain_id + 10 + 2 * index


def local_participants(domain_id: int) -> int:
    """Return how many programs on one machine can discover one another: 119; in domain 232, whose ports end, 62."""
    return min(LOCAL_PARTICIPANTS, (LAST_PORT - 1 - discovery_port(domain_id, 0)) // 2)


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


def is_local() -> bool:
    """Return whether the environment confines the wire to this machine, so that its sockets belong on loopback.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`.
    """
    if os.environ.get("CYCLONEDDS_URI"):
        return False
    return discovery_range() == "LOCALHOST" and not _others(_static_peers())


def is_security_requested() -> bool:
    """Return whether ROS_SECURITY_ENABLE requests DDS Security, which the wheels of cyclonedds are built without."""
    return os.environ.get("ROS_SECURITY_ENABLE") == "true"


def refuse_enforced_security() -> None:
    """Refuse to join without the security that the environment enforces.

    Raises:
        ConfigurationError: ROS_SECURITY_ENABLE is true and ROS_SECURITY_STRATEGY is Enforce.
    """
    if is_security_requested() and os.environ.get("ROS_SECURITY_STRATEGY") == "Enforce":
        raise ConfigurationError(
            "ROS_SECURITY_STRATEGY is Enforce, but the wheels of cyclonedds are built without DDS Security, so nothing "
            "can be encrypted or authenticated: set ROS_SECURITY_ENABLE=false, and protect the network, as by a VPN"
        )


def look_up_peers() -> None:
    """Resolve the hosts of ROS_STATIC_PEERS, because an unknown one makes Cyclone abort the process.

    Raises:
        ConfigurationError: one can't be resolved, or ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`.
    """
    peers = _static_peers()
    if not peers:
        return  # as in most programs, which then need no socket

    import socket

    for peer in peers:
        host, _, port = peer.rpartition(":") if peer.count(":") == 1 else (peer, "", "0")
        try:
            socket.getaddrinfo(host, int(port), socket.AF_INET)
        except (OSError, ValueError, OverflowError) as error:
            raise ConfigurationError(
                f"ROS_STATIC_PEERS names {peer!r}, which is not a host: {error}"
            ) from None


def why_peers_are_ignored() -> str:
    """Return the setting by which ROS_STATIC_PEERS has no effect; empty if it has, or is not set.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of `RANGES`.
    """
    if not os.environ.get("ROS_STATIC_PEERS"):
        return ""
    if os.environ.get("CYCLONEDDS_URI"):
        return "CYCLONEDDS_URI is set"
    if os.environ.get("ROS_LOCALHOST_ONLY") == "1":
        return "ROS_LOCALHOST_ONLY is 1"
    asked = discovery_range()
    return f"the discovery range is {asked}" if asked in RANGES_WITHOUT_PEERS else ""


def _static_peers() -> list[str]:
    """Return the hosts of ROS_STATIC_PEERS that are searched."""
    if why_peers_are_ignored():
        return []
    return [peer.strip() for peer in os.environ.get("ROS_STATIC_PEERS", "").split(";") if peer.strip()]


def configuration_for(
    asked: str,
    static_peers: list[str],
    domain_id: int = 0,
    lease: float | None = None,
    announce_s: float | None = None,
    library_version: str = "",
) -> str:
    """Return the configuration of one of `RANGES`, with a lease and an `announce_s` [s].

    With SYSTEM_DEFAULT and OFF, the peers have no effect.
    """
    others = _others(static_peers) if asked not in RANGES_WITHOUT_PEERS else []
    if others and announce_s is None:
        announce_s = _ANNOUNCE_TO_PEERS_S
    leased = "" if lease is None else f"<LeaseDuration>{lease:.9f}s</LeaseDuration>"
    if announce_s is not None:
        leased += f"<SPDPInterval>{announce_s:.9f}s</SPDPInterval>"
        if not library_version.startswith(
            "0."
        ):  # 0.10 never stops to announce to them, and refuses an unknown element
            leased += "<InitialLocatorPruneDelay>inf</InitialLocatorPruneDelay>"
    if asked == "OFF":
        return _domain("<Transport>none</Transport>", leased, "")  # without a socket
    if asked == "LOCALHOST":
        internal = _RECEIVE_BUFFER if others else _RECEIVE_BUFFER + _PROMPT_ACKNOWLEDGEMENTS
        searched = _peers(["127.0.0.1", *others], domain_id)
        return _domain(_loopback(reach_others=bool(others)), leased + searched, internal)
    if asked == "SUBNET":
        # Cyclone sends to multicast addresses of all that have one, and routers don't forward these to the peers.
        multicast = "spdp" if others else "true"
        searched = _peers(static_peers, domain_id)
        return _domain(f"<AllowMulticast>{multicast}</AllowMulticast>", leased + searched, _RECEIVE_BUFFER)
    return _domain("", leased, "")


def _others(static_peers: list[str]) -> list[str]:
    return [peer for peer in static_peers if peer not in _LOOPBACK]


def _loopback(*, reach_others: bool = False) -> str:
    """Use unicast on the loopback interface, and for other machines the interface that Cyclone selects.

    Cyclone sends by the interface of the greatest priority to a host that is on none of their subnets. By default that
    is the loopback interface, by which no other machine can be reached.
    """
    if not reach_others:
        interfaces = '<NetworkInterface address="127.0.0.1" multicast="false"/>'
        datagrams = _LARGE_DATAGRAMS if sys.platform == "linux" else ""
    else:
        interfaces = (
            '<NetworkInterface address="127.0.0.1" multicast="false" priority="0"/>'
            '<NetworkInterface autodetermine="true" multicast="false" priority="1"/>'
        )
        datagrams = ""
    return f"<Interfaces>{interfaces}</Interfaces><AllowMulticast>false</AllowMulticast>{datagrams}"


def _peers(addresses: list[str], domain_id: int) -> str:
    """Search these hosts, at the port of each participant index; listen at such a port, where others search."""
    peers = "".join(f'<Peer address="{_escaped(address)}"/>' for address in dict.fromkeys(addresses))
    return (
        "<ParticipantIndex>auto</ParticipantIndex>"
        f"<MaxAutoParticipantIndex>{local_participants(domain_id)}</MaxAutoParticipantIndex>"
        + (f"<Peers>{peers}</Peers>" if peers else "")
    )


def _domain(general: str, discovery: str, internal: str) -> str:
    return (
        f"<CycloneDDS><Domain><General>{general}</General><Discovery>{discovery}</Discovery>"
        f"<Internal>{_KEY_HASHES}{internal}</Internal></Domain></CycloneDDS>"
    )


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
