"""The check of `doctor` for programs of this machine that use another wire, and so can't be heard."""

from __future__ import annotations

import socket
from typing import Any

from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.cli.doctor.zenoh import is_zenoh_selected
from tfloom.rmw.errors import WireError

_CONNECT_TIMEOUT_S = 0.5
_ADVICE = "set RMW_IMPLEMENTATION to the same wire in all terminals, or in none, if one of yours is not heard"


def check_other_wire() -> Finding:
    """Look for programs of this machine on Zenoh where the environment selects DDS, and for those on DDS on Zenoh.

    On DDS, it is the port of the machine's Zenoh router; on Zenoh, the ports of the domain's DDS participants, which
    are known on Linux alone.
    """
    try:
        return _dds_beside_zenoh() if is_zenoh_selected() else _zenoh_beside_dds()
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))


def _zenoh_beside_dds() -> Finding:
    from tfloom.rmw.backends import DEFAULT, implementation_identifier
    from tfloom.rmw.zenoh.config import port
    from tfloom.rmw.zenoh.port_holder import find_port_owner

    if implementation_identifier() != DEFAULT:
        return Finding(Verdict.OK, "programs are heard in one process alone")
    number = port()
    try:
        socket.create_connection(("127.0.0.1", number), _CONNECT_TIMEOUT_S).close()
    except OSError:
        return Finding(Verdict.OK, f"no router of Zenoh on this machine, at port {number}")
    owner = find_port_owner(number)
    held = f" ({owner})" if owner else ""
    summary = (
        f"a router of Zenoh is on this machine, at port {number}{held}: its programs aren't heard on DDS"
    )
    return Finding(Verdict.WARNING, summary, _ADVICE, {"router": str(owner or "of an unknown process")})


def _dds_beside_zenoh() -> Finding:
    from tfloom.rmw.backends import domain_id_from_environment
    from tfloom.rmw.cyclone.config import discovery_port, local_participants
    from tfloom.rmw.cyclone.ports import bound_udp_ports

    domain = domain_id_from_environment()
    bound = bound_udp_ports()
    if bound is None:
        return Finding(Verdict.OK, "programs on DDS are not looked for on this system")
    searched = [discovery_port(domain, index) for index in range(local_participants(domain))]
    occupied = [number for number in searched if number in bound]
    if not occupied:
        return Finding(Verdict.OK, f"no program on DDS on this machine, in domain {domain}")
    summary = f"programs on DDS are on this machine, in domain {domain}: they aren't heard on Zenoh"
    details: dict[str, Any] = {"UDP ports of discovery": ", ".join(map(str, occupied))}
    return Finding(Verdict.WARNING, summary, _ADVICE, details)
