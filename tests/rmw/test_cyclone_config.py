"""Cyclone's configuration for the discovery range in the environment."""

from __future__ import annotations

import sys
from xml.etree import ElementTree as ET

import pytest

from tfloom.rmw.cyclone import config as cyclone_config
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.cyclone.config import (
    RANGES,
    configuration,
    configuration_for,
    discovery_port,
    local_participants,
)
from tfloom.rmw.errors import ConfigurationError, WireError

VARIABLES = (
    "CYCLONEDDS_URI",
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_STATIC_PEERS",
    "ROS_LOCALHOST_ONLY",
    "ROS_SECURITY_ENABLE",
    "ROS_SECURITY_STRATEGY",
    "TFLOOM_LEASE_S",
)


@pytest.fixture(autouse=True)
def bare_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)


def domain(text: str) -> ET.Element:
    domain_element = ET.fromstring(text).find("Domain")
    assert domain_element is not None
    return domain_element


def peers(element: ET.Element) -> list[str | None]:
    return [peer.get("address") for peer in element.iterfind("Discovery/Peers/Peer")]


def interfaces(element: ET.Element) -> list[dict[str, str]]:
    return [interface.attrib for interface in element.iterfind("General/Interfaces/NetworkInterface")]


LOOPBACK = {"address": "127.0.0.1", "multicast": "false"}


@pytest.mark.parametrize("value", [None, "", "LOCALHOST"])
def test_localhost_is_unicast_on_loopback_with_room_for_119(monkeypatch, value: str | None) -> None:
    if value is not None:
        monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", value)
    element = domain(configuration())
    assert interfaces(element) == [LOOPBACK]
    assert element.findtext("General/AllowMulticast") == "false"
    assert element.findtext("Discovery/ParticipantIndex") == "auto"
    assert element.findtext("Discovery/MaxAutoParticipantIndex") == "119"
    assert peers(element) == ["127.0.0.1"]


@pytest.mark.parametrize(("domain_id", "most"), [(0, 119), (1, 119), (231, 119), (232, 62)])
def test_participants_of_a_domain_keep_to_its_ports(domain_id: int, most: int) -> None:
    assert local_participants(domain_id) == most
    element = domain(configuration(domain_id))
    assert element.findtext("Discovery/MaxAutoParticipantIndex") == str(most)
    last_port = discovery_port(domain_id, most - 1) + 1
    assert last_port < min(7400 + 250 * (domain_id + 1), 65536)


@pytest.mark.parametrize("discovery_range", RANGES)
@pytest.mark.parametrize(("value", "lease"), [("2", 2.0), (" 2.5 ", 2.5), ("3600", 3600.0)])
def test_lease_is_announced_in_each_range(
    monkeypatch, discovery_range: str, value: str, lease: float
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", discovery_range)
    monkeypatch.setenv("TFLOOM_LEASE_S", value)
    text = domain(configuration()).findtext("Discovery/LeaseDuration")
    assert text is not None
    assert text.endswith("s")
    assert float(text[:-1]) == lease


@pytest.mark.parametrize("value", [None, "", " "])
def test_lease_is_that_of_cyclone_by_default(monkeypatch, value: str | None) -> None:
    if value is not None:
        monkeypatch.setenv("TFLOOM_LEASE_S", value)
    assert domain(configuration()).find("Discovery/LeaseDuration") is None


@pytest.mark.parametrize("value", ["1.9", "0", "-2", "3601", "inf", "nan", "10s", "ten"])
def test_invalid_lease_is_named_with_the_valid_ones(monkeypatch, value: str) -> None:
    monkeypatch.setenv("TFLOOM_LEASE_S", value)
    with pytest.raises(ConfigurationError) as error:
        configuration()
    assert str(error.value) == f"TFLOOM_LEASE_S is {value!r}, which is not a number of seconds from 2 to 3600"


@pytest.mark.parametrize(
    ("platform", "peers", "size"),
    [
        ("linux", [], "65500B"),
        ("linux", ["localhost"], "65500B"),
        ("linux", ["192.0.2.1"], None),
        ("darwin", [], None),
    ],
)
def test_datagrams_are_large_on_a_loopback_that_allows_it(monkeypatch, platform, peers, size) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    element = domain(configuration_for("LOCALHOST", peers))
    assert element.findtext("General/MaxMessageSize") == size


@pytest.mark.parametrize("discovery_range", ["LOCALHOST", "SUBNET"])
def test_socket_buffers_hold_a_burst(discovery_range: str) -> None:
    buffer = domain(configuration_for(discovery_range, [])).find("Internal/SocketReceiveBufferSize")
    assert buffer is not None
    assert buffer.attrib == {"max": "4MB"}


@pytest.mark.parametrize("discovery_range", ["LOCALHOST", "SUBNET", "SYSTEM_DEFAULT"])
def test_key_hashes_tell_fast_dds_what_is_closed(discovery_range: str) -> None:
    assert domain(configuration_for(discovery_range, [])).findtext("Internal/GenerateKeyhash") == "true"


@pytest.mark.parametrize(
    ("discovery_range", "peers", "periods"),
    [
        ("LOCALHOST", [], ["20ms", "1ms", "2ms"]),
        ("LOCALHOST", ["192.0.2.1"], [None] * 3),
        ("SUBNET", [], [None] * 3),
    ],
)
def test_acknowledgements_are_prompt_on_loopback_alone(
    discovery_range: str, peers: list[str], periods: list[str | None]
) -> None:
    element = domain(configuration_for(discovery_range, peers))
    found = [
        element.findtext(f"Internal/{name}")
        for name in ("HeartbeatInterval", "PreEmptiveAckDelay", "NackDelay")
    ]
    assert found == periods


def test_localhost_with_static_peers_searches_them_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", " 192.0.2.1 ;; robot.example;localhost;192.0.2.1")
    element = domain(configuration())
    assert peers(element) == ["127.0.0.1", "192.0.2.1", "robot.example"]
    # Hosts on no subnet of these interfaces are sent to by that of the greatest priority.
    assert interfaces(element) == [
        {**LOOPBACK, "priority": "0"},
        {"autodetermine": "true", "multicast": "false", "priority": "1"},
    ]
    assert element.findtext("General/AllowMulticast") == "false"


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF", "the discovery range is OFF"),
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SYSTEM_DEFAULT", "the discovery range is SYSTEM_DEFAULT"),
        ("ROS_LOCALHOST_ONLY", "1", "ROS_LOCALHOST_ONLY is 1"),
        ("CYCLONEDDS_URI", "<CycloneDDS/>", "CYCLONEDDS_URI is set"),
    ],
)
def test_static_peers_have_no_effect_with_some_settings(
    name: str, value: str, reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(name, value)
    assert cyclone_config.why_peers_are_ignored() == ""
    without = configuration()
    monkeypatch.setenv("ROS_STATIC_PEERS", "no host at all")
    assert configuration() == without
    cyclone_config.look_up_peers()
    assert cyclone_config.why_peers_are_ignored() == reason


@pytest.mark.parametrize("asked", ["LOCALHOST", "SUBNET"])
def test_static_peers_have_an_effect_with_the_others(asked: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", asked)
    monkeypatch.setenv("ROS_STATIC_PEERS", "192.0.2.1")
    assert "192.0.2.1" in peers(domain(configuration()))
    assert cyclone_config.why_peers_are_ignored() == ""


def test_subnet_is_multicast_on_the_interface_that_cyclone_selects() -> None:
    element = domain(configuration_for("SUBNET", []))
    assert interfaces(element) == []
    assert element.findtext("General/AllowMulticast") == "true"
    assert peers(element) == []
    # Others that name this host in ROS_STATIC_PEERS search it at the ports of the indices.
    assert element.findtext("Discovery/ParticipantIndex") == "auto"


def test_subnet_with_static_peers() -> None:
    element = domain(configuration_for("SUBNET", ["192.0.2.1"]))
    assert peers(element) == ["192.0.2.1"]
    assert element.findtext("Discovery/ParticipantIndex") == "auto"
    assert element.findtext("General/AllowMulticast") == "spdp"


def test_off_is_without_a_network() -> None:
    element = domain(configuration_for("OFF", ["192.0.2.1"]))
    assert peers(element) == []
    assert interfaces(element) == []
    assert element.findtext("General/Transport") == "none"


@pytest.mark.parametrize("static_peers", [[], ["192.0.2.1"]])
def test_system_default_configures_no_discovery(static_peers: list[str]) -> None:
    element = domain(configuration_for("SYSTEM_DEFAULT", static_peers))
    assert [[setting.tag for setting in child] for child in element] == [[], [], ["GenerateKeyhash"]]


@pytest.mark.parametrize("discovery_range", RANGES)
def test_explicit_uri_takes_precedence(monkeypatch: pytest.MonkeyPatch, discovery_range: str) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", discovery_range)
    monkeypatch.setenv("CYCLONEDDS_URI", "file:///etc/cyclone.xml")
    assert configuration() == "file:///etc/cyclone.xml"


def test_localhost_only_variable_selects_localhost(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")
    monkeypatch.setenv("ROS_LOCALHOST_ONLY", "1")
    assert configuration() == configuration_for("LOCALHOST", [])


def test_unknown_range_error_lists_the_known_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "GALAXY")
    with pytest.raises(
        ConfigurationError, match="'GALAXY', which is none of: LOCALHOST, SUBNET, OFF, SYSTEM_DEFAULT"
    ):
        configuration()


def test_peer_names_are_escaped_in_xml() -> None:
    odd = '"/></Peers><&'
    assert peers(domain(configuration_for("SUBNET", [odd]))) == [odd]


def test_uri_rejected_by_cyclone_is_named_in_the_error(domain_id, monkeypatch, capfd) -> None:
    monkeypatch.setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><Nonsense/></Domain></CycloneDDS>")
    with pytest.raises(WireError, match="see Cyclone's message above, and check CYCLONEDDS_URI"):
        cyclonedds.open_participant(domain_id)
    assert "Nonsense" in capfd.readouterr().err


FULL_DOMAIN = """
import os
from tfloom.rmw.cyclone import config as cyclone_config
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.errors import WireError

cyclone_config.LOCAL_PARTICIPANTS = 1
try:
    cyclonedds.open_participant(int(os.environ["ROS_DOMAIN_ID"]))
except WireError as error:
    print(error)
"""


def test_full_domain_error_has_the_remedy(start_peer, start_program) -> None:
    """In a separate process, because libddsc leaves the ports bound that it tried last."""
    start_peer()
    program = start_program("python", "-c", FULL_DOMAIN)
    assert program.wait() == 0, program.output
    assert "choose another ROS_DOMAIN_ID if 1 are on this domain" in program.output
    assert "free participant index" in program.output


@pytest.mark.parametrize("peer", ["x y", "::", "127.0.0.1:x", "127.0.0.1:99999999999999999999"])
def test_unknown_host_of_a_peer_is_named_in_the_error(peer: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", f"127.0.0.1; 127.0.0.1:7400;{peer}")
    with pytest.raises(ConfigurationError, match="ROS_STATIC_PEERS names") as error:
        cyclone_config.look_up_peers()
    assert repr(peer) in str(error.value)
    monkeypatch.setenv("ROS_STATIC_PEERS", "127.0.0.1; 127.0.0.1:7400")
    cyclone_config.look_up_peers()


def test_enforced_security_is_refused(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_SECURITY_ENABLE", "true")
    monkeypatch.setenv("ROS_SECURITY_STRATEGY", "Enforce")
    with pytest.raises(
        ConfigurationError, match="is Enforce, but the wheels of cyclonedds are built without"
    ):
        cyclonedds.open_participant(domain_id)


@pytest.mark.parametrize(
    ("enable", "strategy"), [("true", "Permissive"), ("true", ""), ("false", "Enforce"), ("TRUE", "Enforce")]
)
def test_security_that_is_not_enforced_is_not_refused(
    enable: str, strategy: str, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_SECURITY_ENABLE", enable)
    monkeypatch.setenv("ROS_SECURITY_STRATEGY", strategy)
    cyclonedds.open_participant(domain_id).close()


def test_the_library_has_no_security(domain_id: int, monkeypatch, capfd) -> None:
    """Then `refuse_enforced_security` and docs/security.md are right; otherwise both are due."""
    if (library := cyclonedds.open_library()).version.startswith("0.10."):
        pytest.skip(f"libddsc {library.version} of {library.origin} may have it; tfloom doesn't use it")
    monkeypatch.setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><Security/></Domain></CycloneDDS>")
    with pytest.raises(WireError):
        cyclonedds.open_participant(domain_id)
    assert "Security: unknown element" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("environment", "expected"),
    [
        ({}, True),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "ROS_LOCALHOST_ONLY": "1"}, True),
        ({"ROS_STATIC_PEERS": "localhost; 127.0.0.1"}, True),
        ({"ROS_STATIC_PEERS": "localhost;192.0.2.1"}, False),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}, False),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT"}, False),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}, False),
        ({"CYCLONEDDS_URI": "file:///etc/cyclone.xml"}, False),
    ],
)
def test_the_wire_is_local_unless_something_reaches_others(
    environment: dict[str, str], expected: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert cyclone_config.is_local() is expected


def test_period_of_announcements_is_that_of_the_argument() -> None:
    discovery = domain(configuration(7, 0.5)).find("Discovery")
    assert discovery is not None
    assert discovery.findtext("SPDPInterval") == "0.500000000s"
    assert discovery.findtext("InitialLocatorPruneDelay") == "inf"
    assert domain(configuration(7)).find("Discovery/SPDPInterval") is None
    before_11 = domain(configuration(7, 0.5, "0.10.2")).find("Discovery")
    assert before_11 is not None
    assert before_11.findtext("SPDPInterval") == "0.500000000s"
    assert before_11.find("InitialLocatorPruneDelay") is None


@pytest.mark.parametrize("discovery_range", ["LOCALHOST", "SUBNET"])
def test_other_hosts_get_announcements_for_good(discovery_range: str) -> None:
    alone = domain(configuration_for(discovery_range, ["localhost"]))
    assert alone.find("Discovery/SPDPInterval") is None
    element = domain(configuration_for(discovery_range, ["192.0.2.1"]))
    assert element.findtext("Discovery/SPDPInterval") == "3.000000000s"
    assert element.findtext("Discovery/InitialLocatorPruneDelay") == "inf"
