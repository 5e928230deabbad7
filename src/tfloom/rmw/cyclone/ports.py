"""The processes on this machine that hold the ports of a domain, whether or not they have been discovered."""

from __future__ import annotations

import os
from collections.abc import Iterable

from tfloom.rmw.cyclone.config import discovery_port, discovery_range, local_participants

_SOCKETS = "/proc/net/udp"
_SOCKETS_OF_IPV6 = "/proc/net/udp6"
_CYCLONE = bytes([1, 0x10])


def bound_indices(domain_id: int) -> set[int]:
    """Return the participant indices of a domain whose two UDP ports are bound on this machine.

    Empty where they are not known: on other systems than Linux, and unless programs on this machine discover each other
    by these ports, that is, in the range LOCALHOST without a CYCLONEDDS_URI.
    """
    if os.environ.get("CYCLONEDDS_URI") or discovery_range() != "LOCALHOST":
        return set()
    try:
        return _indices(domain_id, _ports(_SOCKETS))
    except OSError:
        return set()


def bound_udp_ports() -> set[int] | None:
    """Return the UDP ports of this machine that are bound; None on a system that doesn't tell."""
    try:
        ports = _ports(_SOCKETS)
        if os.path.exists(_SOCKETS_OF_IPV6):  # see `_ports`; IPv6 may be off
            ports |= _ports(_SOCKETS_OF_IPV6)
    except (OSError, ValueError, IndexError):
        return None
    return ports


def process_count(participants: Iterable[bytes]) -> int:
    """Return the number of processes to which these participants belong, given by their gids of 16 bytes.

    Those of Cyclone in one process share their ports and the first 4 bytes; other implementations open ports for each
    participant. Two processes may share these bytes by chance (1 in 65,536), and are then counted as one.
    """
    return len({gid[:4] if gid.startswith(_CYCLONE) else gid for gid in participants})


def _ports(path: str) -> set[int]:
    """Return the local ports in one of the kernel's tables of UDP sockets: `sl: address:port …`, in hexadecimal."""
    # Each program on DDS reads a table as it starts, and importing pathlib would take longer than all of it.
    with open(path, encoding="ascii") as table:
        lines = table.readlines()[1:]
    return {int(line.split(maxsplit=2)[1].rpartition(":")[2], 16) for line in lines}


def _indices(domain_id: int, ports: set[int]) -> set[int]:
    first = {index: discovery_port(domain_id, index) for index in range(local_participants(domain_id))}
    return {index for index, port in first.items() if port in ports and port + 1 in ports}
