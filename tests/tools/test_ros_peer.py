"""tools/ros_peer.py without a network: why there is no peer, and how its programs are started."""

from __future__ import annotations

import json
import platform
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from tools import ros_peer
from tools.set_up import RECORD, SetUpError, digest_of

XML = {"dds": "http://www.eprosima.com"}


@pytest.fixture(autouse=True)
def _supported_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, "system", lambda: "Linux")
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(platform, "libc_ver", lambda: ("glibc", "2.36"))
    monkeypatch.setattr(ros_peer, "VERSION", (3, 11))


def write_record(where: Path, **record: str) -> None:
    (where / RECORD).write_text(json.dumps({"folder": str(where), **record}))


def test_the_machine_has_wheels() -> None:
    assert ros_peer.why_impossible() is None


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("platform.system", lambda: "Darwin", "Linux on x86-64, and this is Darwin"),
        ("platform.machine", lambda: "aarch64", "and this is Linux on aarch64"),
        ("platform.libc_ver", lambda: ("", ""), "need glibc"),
        ("tools.ros_peer.VERSION", (3, 14), "Python 3.10 to 3.13, and this is 3.14: make ros-peer PYTHON="),
        ("tools.ros_peer.VERSION", (3, 9), "and this is 3.9"),
    ],
)
def test_one_sentence_names_the_reason_where_there_are_no_wheels(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str, value: object, reason: str
) -> None:
    monkeypatch.setattr(name, value)
    with pytest.raises(SetUpError, match=reason) as raised:
        ros_peer.install(tmp_path / "peer")
    assert "\n" not in str(raised.value)
    with pytest.raises(ros_peer.NoPeerError, match=reason):
        ros_peer.find(tmp_path / "peer")
    assert not (tmp_path / "peer").exists()


def test_each_release_has_its_own_pythons_and_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kilted = ros_peer.KILTED
    with pytest.raises(ros_peer.NoPeerError, match="`make ros-peer ROS_DISTRO=kilted` installs it"):
        ros_peer.find(tmp_path, kilted)
    write_record(tmp_path, wheels=digest_of(ros_peer.WHEELS))
    with pytest.raises(ros_peer.NoPeerError, match="kilted"):
        ros_peer.find(tmp_path, kilted)  # these are Jazzy's
    write_record(tmp_path, wheels=digest_of(kilted.wheels))
    assert ros_peer.find(tmp_path, kilted).python == tmp_path / "bin" / "python"
    assert len({release.folder for release in ros_peer.RELEASES.values()}) == len(ros_peer.RELEASES)
    monkeypatch.setattr(ros_peer, "VERSION", (3, 12))
    assert ros_peer.why_impossible() is None
    reason = "of kilted are for Python 3.11, and this is 3.12: make ros-peer PYTHON=python3.11"
    assert reason in (ros_peer.why_impossible(kilted) or "")


@pytest.mark.parametrize(
    ("given", "installed"), [(None, "jazzy"), ("jazzy", "jazzy"), ("kilted", "kilted"), ("rolling", "jazzy")]
)
def test_release_of_the_environment_is_installed(
    given: str | None, installed: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    if given is not None:
        monkeypatch.setenv("ROS_DISTRO", given)
    names: list[str] = []
    monkeypatch.setattr(ros_peer, "install", lambda *, release: names.append(release.name))
    assert (ros_peer.main(), names) == (0, [installed])


def test_a_missing_peer_is_not_found(tmp_path: Path) -> None:
    with pytest.raises(ros_peer.NoPeerError, match="`make ros-peer` installs it"):
        ros_peer.find(tmp_path)


def test_an_incomplete_peer_is_not_found(tmp_path: Path) -> None:
    write_record(tmp_path, unfinished="wheels")
    with pytest.raises(ros_peer.NoPeerError, match="make ros-peer"):
        ros_peer.find(tmp_path)


def test_a_peer_of_other_versions_is_not_found(tmp_path: Path) -> None:
    write_record(tmp_path, wheels=digest_of(["ros-jazzy-rclpy==7.1.5"]))
    with pytest.raises(ros_peer.NoPeerError, match="make ros-peer"):
        ros_peer.find(tmp_path)


def test_a_peer_that_was_moved_is_not_found(tmp_path: Path) -> None:
    write_record(tmp_path, wheels=digest_of(ros_peer.WHEELS), folder="/elsewhere")
    with pytest.raises(ros_peer.NoPeerError, match="make ros-peer"):
        ros_peer.find(tmp_path)


def test_a_peer_without_compiled_interfaces_is_found_and_has_none_of_them(tmp_path: Path) -> None:
    write_record(tmp_path, wheels=digest_of(ros_peer.WHEELS), unfinished="interfaces")
    assert not ros_peer.find(tmp_path).has("tf2_msgs")


def test_a_peer_with_compiled_interfaces_has_these_alone(tmp_path: Path) -> None:
    write_record(tmp_path, wheels=digest_of(ros_peer.WHEELS), interfaces="…")
    peer = ros_peer.find(tmp_path)
    assert peer.has("tf2_msgs")
    assert peer.has("example_interfaces")
    assert not peer.has("nav2_msgs")


def test_programs_of_the_peer_get_none_of_the_users_discovery(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", "192.0.2.1")
    monkeypatch.setenv("FASTDDS_BUILTIN_TRANSPORTS", "DEFAULT")
    monkeypatch.setenv("LD_LIBRARY_PATH", "/opt/ros/jazzy/lib")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("HOME", "/home/of/a/user")
    environment = ros_peer.RosPeer(tmp_path).environment(7, EXTRA="1")
    assert {"ROS_STATIC_PEERS", "FASTDDS_BUILTIN_TRANSPORTS", "LD_LIBRARY_PATH"}.isdisjoint(environment)
    assert environment["ROS_DOMAIN_ID"] == "7"
    assert environment["RMW_IMPLEMENTATION"] == "rmw_fastrtps_cpp"
    assert environment["EXTRA"] == "1"
    assert environment["HOME"] == "/home/of/a/user"


def test_the_profile_has_the_loopback_transport_alone() -> None:
    root = ET.parse(ros_peer.PROFILE).getroot()
    transport = root.find("dds:transport_descriptors/dds:transport_descriptor", XML)
    assert [element.text for element in transport.findall("dds:interfaceWhiteList/dds:address", XML)] == [
        "127.0.0.1"
    ]
    rtps = root.find("dds:participant[@is_default_profile='true']/dds:rtps", XML)
    assert rtps.find("dds:useBuiltinTransports", XML).text == "false"
    assert [element.text for element in rtps.findall("dds:userTransports/dds:transport_id", XML)] == [
        transport.find("dds:transport_id", XML).text
    ]
    assert {element.text for element in rtps.findall(".//dds:address", XML)} == {"127.0.0.1"}
