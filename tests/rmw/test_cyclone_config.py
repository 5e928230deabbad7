"""Cyclone's configuration for the discovery range in the environment."""

from __future__ import annotations

import os
import sys
from xml.etree import ElementTree as ET

import pytest

from tfloom.rmw import cyclone_config, cyclonedds
from tfloom.rmw.cyclone_config import RANGES, configuration, configuration_for
from tfloom.rmw.errors import ConfigurationError, WireError

VARIABLES = ("CYCLONEDDS_URI", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS", "ROS_LOCALHOST_ONLY")


@pytest.fixture(autouse=True)
def bare_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)


def domain(text: str) -> ET.Element:
    found = ET.fromstring(text).find("Domain")
    assert found is not None
    return found


def peers(element: ET.Element) -> list[str | None]:
    return [peer.get("address") for peer in element.iterfind("Discovery/Peers/Peer")]


def interfaces(element: ET.Element) -> list[dict[str, str]]:
    return [interface.attrib for interface in element.iterfind("General/Interfaces/NetworkInterface")]


LOOPBACK = {"address": "127.0.0.1", "multicast": "false"}


@pytest.mark.parametrize("value", [None, "", "LOCALHOST"])
def test_localhost_is_unicast_on_loopback_with_room_for_sixty(monkeypatch, value: str | None) -> None:
    if value is not None:
        monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", value)
    element = domain(configuration())
    assert interfaces(element) == [LOOPBACK]
    assert element.findtext("General/AllowMulticast") == "false"
    assert element.findtext("Discovery/ParticipantIndex") == "auto"
    assert element.findtext("Discovery/MaxAutoParticipantIndex") == "60"
    assert peers(element) == ["127.0.0.1"]


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


@pytest.mark.parametrize("discovery_range", ["LOCALHOST", "SUBNET", "OFF"])
def test_socket_buffers_hold_a_burst(discovery_range: str) -> None:
    buffer = domain(configuration_for(discovery_range, [])).find("Internal/SocketReceiveBufferSize")
    assert buffer is not None
    assert buffer.attrib == {"max": "4MB"}


@pytest.mark.parametrize(
    ("discovery_range", "peers", "interval"),
    [
        ("LOCALHOST", [], "20ms"),
        ("OFF", [], "20ms"),
        ("LOCALHOST", ["192.0.2.1"], None),
        ("SUBNET", [], None),
    ],
)
def test_acknowledgements_are_requested_often_on_loopback_alone(discovery_range, peers, interval) -> None:
    element = domain(configuration_for(discovery_range, peers))
    assert element.findtext("Internal/HeartbeatInterval") == interval


def test_localhost_with_static_peers_searches_them_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", " 192.0.2.1 ;; robot.example;localhost;192.0.2.1")
    element = domain(configuration())
    assert peers(element) == ["127.0.0.1", "192.0.2.1", "robot.example"]
    assert interfaces(element) == [LOOPBACK, {"autodetermine": "true", "multicast": "false"}]
    assert element.findtext("General/AllowMulticast") == "false"


def test_subnet_is_multicast_on_the_interface_that_cyclone_selects() -> None:
    element = domain(configuration_for("SUBNET", []))
    assert interfaces(element) == []
    assert element.findtext("General/AllowMulticast") == "true"
    assert peers(element) == []
    assert element.find("Discovery/ParticipantIndex") is None


def test_subnet_with_static_peers() -> None:
    element = domain(configuration_for("SUBNET", ["192.0.2.1"]))
    assert peers(element) == ["192.0.2.1"]
    assert element.findtext("Discovery/ParticipantIndex") == "auto"


def test_off_has_no_peers_and_a_tag_of_its_own() -> None:
    element = domain(configuration_for("OFF", ["192.0.2.1"]))
    assert peers(element) == []
    assert interfaces(element) == [LOOPBACK]
    assert element.findtext("Discovery/ParticipantIndex") == "none"
    assert element.findtext("Discovery/Tag") == f"tfloom-off-{os.getpid()}"


def test_system_default_is_an_empty_configuration() -> None:
    element = domain(configuration_for("SYSTEM_DEFAULT", []))
    assert [list(child) for child in element] == [[], [], []]


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


def test_full_domain_error_has_the_remedy(domain_id, monkeypatch, start_peer, capfd) -> None:
    start_peer()
    monkeypatch.setattr(cyclone_config, "LOCAL_PARTICIPANTS", 1)
    with pytest.raises(WireError, match="choose another ROS_DOMAIN_ID if 1 are on this domain"):
        cyclonedds.open_participant(domain_id)
    assert "free participant index" in capfd.readouterr().err


@pytest.mark.parametrize("peer", ["x y", "::", "127.0.0.1:x", "127.0.0.1:99999999999999999999"])
def test_unknown_host_of_a_peer_is_named_in_the_error(peer: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", f"127.0.0.1; 127.0.0.1:7400;{peer}")
    with pytest.raises(ConfigurationError, match="ROS_STATIC_PEERS names") as error:
        cyclone_config.look_up_peers()
    assert repr(peer) in str(error.value)
    monkeypatch.setenv("ROS_STATIC_PEERS", "127.0.0.1; 127.0.0.1:7400")
    cyclone_config.look_up_peers()
