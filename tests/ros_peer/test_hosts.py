"""Two hosts, in network namespaces: tfloom on one, and on the other Fast DDS or tfloom, without a profile."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import pytest
from tests.conftest import Program
from tests.namespaces import (
    Host,
    containers_of_a_host,
    hosts_behind_a_router,
    hosts_on_a_subnet,
    packets_so_far,
)
from tools.ros_peer import RosPeer

from .conftest import OURS, THEIRS, End, starter
from .test_services import SERVICE_END

pytestmark = pytest.mark.ros

MEGABYTE = 1_000_000
KEPT = {"durability": "TRANSIENT_LOCAL"}
"""So that a message that precedes the match arrives, too."""
RANGE, PEERS = "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS"
NEAR, FAR = "{near}", "{far}"
"""Stand for the addresses of the hosts in the settings of a case."""

SUBNET_CASES = {
    "subnet": ({RANGE: "SUBNET"}, {RANGE: "SUBNET"}),
    "system default": ({RANGE: "SYSTEM_DEFAULT"}, {RANGE: "SYSTEM_DEFAULT"}),
}
PEER_CASES = {
    "subnet, both name peers": ({RANGE: "SUBNET", PEERS: FAR}, {RANGE: "SUBNET", PEERS: NEAR}),
    "subnet, the near one names a peer": ({RANGE: "SUBNET", PEERS: FAR}, {RANGE: "SUBNET"}),
    "subnet, the far one names a peer": ({RANGE: "SUBNET"}, {RANGE: "SUBNET", PEERS: NEAR}),
    "localhost, both name peers": ({RANGE: "LOCALHOST", PEERS: FAR}, {RANGE: "LOCALHOST", PEERS: NEAR}),
    "near subnet, far localhost and peers": ({RANGE: "SUBNET"}, {RANGE: "LOCALHOST", PEERS: NEAR}),
}


class Side(NamedTuple):
    """The processes on a host: one with topics, and one with services."""

    topics: End
    services: End


Sides = Callable[[tuple[Host, Host], str, tuple[dict[str, str], dict[str, str]]], tuple[Side, Side]]


@pytest.fixture
def start_sides(peer: RosPeer, domain_id: int, start_program: Callable[..., Program]) -> Sides:
    """Return a function that starts tfloom on the near host, and a vendor on the far one, with a case's settings."""

    def start_side(host: Host, vendor: str, name: str, settings: dict[str, str]) -> Side:
        def start(*command: Any, **options: Any) -> Program:
            return start_program(*host.enter, *command, **options)

        settings = {peer.release.profile_variable: "", **settings}
        topics = starter(peer, domain_id, start)(vendor, f"{name}_topics", **settings)
        services = starter(peer, domain_id, start, SERVICE_END)(vendor, f"{name}_services", **settings)
        return Side(topics, services)

    def start_both(
        hosts: tuple[Host, Host], vendor: str, case: tuple[dict[str, str], dict[str, str]]
    ) -> tuple[Side, Side]:
        near, far = hosts
        assert near.address is not None
        assert far.address is not None
        addresses = {NEAR: near.address, FAR: far.address}
        of_near, of_far = (
            {name: addresses.get(value, value) for name, value in settings.items()} for settings in case
        )
        return start_side(near, OURS, "near", of_near), start_side(far, vendor, "far", of_far)

    return start_both


def assert_passes(writer: Side, reader: Side, topic: str, wait_until: Callable[..., None]) -> None:
    """Pass a short and a large message, and call a service for a short and a large response, one way."""
    for kind, sent, received in (
        ("text", "over the cable", "over the cable"),
        ("octets", [7, MEGABYTE], [7, MEGABYTE]),
    ):
        reader.topics("subscription", kind + topic, kind, f"/{kind}{topic}", KEPT)
        writer.topics("publisher", kind + topic, kind, f"/{kind}{topic}", KEPT)
        writer.topics("publish", kind + topic, sent)
        wait_until(lambda key=kind + topic: reader.topics("count", key) == 1, what=f"{kind}{topic}")
        (message,) = reader.topics("received", kind + topic)
        assert message[: len(received)] == received
    for size in (10, MEGABYTE):
        name = f"/{topic}_{size}"
        writer.services("text_server", name, size)
        reader.services("clients", name, 1, "text")
        assert reader.services("call_text", name, 3) == [size] * 3


def assert_all_passes(near: Side, far: Side, wait_until: Callable[..., None]) -> None:
    """Pass messages and responses both ways."""
    assert_passes(near, far, "out", wait_until)
    assert_passes(far, near, "back", wait_until)


@pytest.mark.parametrize("vendor", [THEIRS, OURS])
@pytest.mark.parametrize("case", SUBNET_CASES)
def test_hosts_of_a_subnet_meet_by_multicast(
    case: str,
    vendor: str,
    start_sides: Sides,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    near, far = start_sides(hosts_on_a_subnet(start_program), vendor, SUBNET_CASES[case])
    assert_all_passes(near, far, wait_until)


@pytest.mark.parametrize("vendor", [THEIRS, OURS])
@pytest.mark.parametrize("case", PEER_CASES)
def test_hosts_behind_a_router_meet_by_static_peers(
    case: str,
    vendor: str,
    start_sides: Sides,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    near, far = start_sides(hosts_behind_a_router(start_program), vendor, PEER_CASES[case])
    assert_all_passes(near, far, wait_until)


@pytest.mark.parametrize("vendor", [THEIRS, OURS])
def test_containers_on_the_network_of_their_host_meet(
    vendor: str, start_sides: Sides, start_program: Callable[..., Program], wait_until: Callable[..., None]
) -> None:
    """Fast DDS announces shared memory, which the other container does not have; tfloom uses UDP alone."""
    case = ({RANGE: "LOCALHOST"}, {RANGE: "LOCALHOST"})
    near, far = start_sides(containers_of_a_host(start_program), vendor, case)
    assert_all_passes(near, far, wait_until)


@pytest.mark.parametrize("vendor", [THEIRS, OURS])
def test_a_host_with_static_peers_meets_its_own_processes_too(
    vendor: str, start_sides: Sides, start_program: Callable[..., Program], wait_until: Callable[..., None]
) -> None:
    """A process that reaches another machine, and one here that is confined to this one."""
    near, _ = hosts_on_a_subnet(start_program)
    case = ({RANGE: "LOCALHOST", PEERS: "10.77.0.2"}, {RANGE: "LOCALHOST"})
    reaching, confined = start_sides((near, near), vendor, case)
    assert_all_passes(reaching, confined, wait_until)


@pytest.mark.parametrize(
    ("settings", "is_silent"), [({}, True), ({RANGE: "SUBNET"}, False)], ids=["localhost", "subnet"]
)
def test_no_packet_leaves_the_loopback_interface(
    settings: dict[str, str],
    is_silent: bool,
    peer: RosPeer,
    domain_id: int,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    """The default of tfloom and the profile of the tests' peer; with another range of tfloom, packets are seen."""
    host, _ = hosts_on_a_subnet(start_program)
    sniffing = host.sniff(start_program)

    def start(*command: Any, **options: Any) -> Program:
        return start_program(*host.enter, *command, **options)

    sides = [
        Side(
            starter(peer, domain_id, start)(vendor, f"{name}_topics", **settings),
            starter(peer, domain_id, start, SERVICE_END)(vendor, f"{name}_services", **settings),
        )
        for name, vendor in (("ours", OURS), ("theirs", THEIRS))
    ]
    assert_all_passes(*sides, wait_until)
    assert (packets_so_far(host, sniffing) == []) is is_silent
