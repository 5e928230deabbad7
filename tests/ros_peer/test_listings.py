"""Nodes and topics of each vendor in the lists of the other, with the hashes of their types."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable
from typing import Any

import pytest
from tests.conftest import run_to_end
from tools.ros_peer import KILTED, RosPeer

from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent
from tfloom.interfaces.std_msgs.msg import Int64, String, UInt8MultiArray

from .conftest import FROM_US, OURS, THEIRS, TO_US, End, StartEnd

pytestmark = pytest.mark.ros

LISTINGS = 10
"""How many listings in a row must be complete; fifty were by hand."""
LISTING_S = 30.0
TOPICS = {"text": ("/words", String), "number": ("/counts", Int64), "octets": ("/blobs", UInt8MultiArray)}


def ros2(*words: str) -> str:
    """Run a command on the test's domain, and return its output.

    A listing that must wait says so on stderr, which is not checked here.
    """
    done = run_to_end([sys.executable, "-m", "tfloom", *words], timeout_s=LISTING_S)
    assert done.returncode == 0, done.stderr
    return done.stdout


def open_all(end: End) -> None:
    """Open a publisher and a subscription of each kind of TOPICS."""
    for kind, (topic, _) in TOPICS.items():
        end("publisher", f"p_{kind}", kind, topic, {"depth": 3, "durability": "TRANSIENT_LOCAL"})
        end("subscription", f"s_{kind}", kind, topic, {"depth": 3, "reliability": "BEST_EFFORT"})


def start_robot(start_end: StartEnd, vendor: str, name: str = "robot") -> End:
    end = start_end(vendor, name, "--ros-args", "-r", "__ns:=/fleet")
    open_all(end)
    return end


@pytest.mark.row("nodes, listed", direction=TO_US)
def test_nodes_of_fast_dds_are_listed(start_end: StartEnd) -> None:
    start_robot(start_end, THEIRS)
    start_end(THEIRS, "second")
    assert ros2("node", "list").split() == ["/fleet/robot", "/second"]
    about = ros2("node", "info", "/fleet/robot")
    for topic, message_class in TOPICS.values():
        assert about.count(f"    {topic}: {message_class._TYPE_NAME}\n") == 2
    assert "/fleet/robot/get_parameters: rcl_interfaces/srv/GetParameters" in about


@pytest.mark.row("nodes, listed", direction=FROM_US)
def test_nodes_of_tfloom_are_listed_by_fast_dds(start_end: StartEnd, wait_until: Callable[..., None]) -> None:
    start_robot(start_end, OURS)
    start_end(OURS, "second")
    theirs = start_end(THEIRS, "asker")
    expected = ["/asker", "/fleet/robot", "/second"]
    wait_until(lambda: theirs("nodes") == expected, what=str(expected))


@pytest.mark.row("topics, listed with types and hashes", direction=TO_US)
def test_topics_of_fast_dds_are_listed(start_end: StartEnd) -> None:
    start_robot(start_end, THEIRS)
    expected = {"/parameter_events": "rcl_interfaces/msg/ParameterEvent", "/rosout": "rcl_interfaces/msg/Log"}
    expected |= {topic: message_class._TYPE_NAME for topic, message_class in TOPICS.values()}
    listed = ros2("topic", "list", "-t").splitlines()
    assert listed == [f"{topic} [{expected[topic]}]" for topic in sorted(expected)]
    for topic, message_class in TOPICS.values():
        assert ros2("topic", "type", topic).strip() == message_class._TYPE_NAME
        about: dict[str, Any] = json.loads(ros2("topic", "info", "--json", topic))
        for side, reliability, durability in (
            ("publishers", "RELIABLE", "TRANSIENT_LOCAL"),
            ("subscriptions", "BEST_EFFORT", "VOLATILE"),
        ):
            (found,) = about[side]
            assert (found["node"], found["type"]) == ("/fleet/robot", message_class._TYPE_NAME)
            assert found["type_hash"] == message_class._TYPE_HASH
            assert reliability in str(found["qos"])
            assert durability in str(found["qos"])
    assert f"Topic type hash: {ParameterEvent._TYPE_HASH}" in ros2("topic", "info", "-v", "/parameter_events")


@pytest.mark.row("topics, listed with types and hashes", direction=FROM_US)
def test_topics_of_tfloom_are_listed_by_fast_dds(
    start_end: StartEnd, wait_until: Callable[..., None]
) -> None:
    start_robot(start_end, OURS)
    theirs = start_end(THEIRS, "asker")
    for topic, message_class in TOPICS.values():
        wait_until(
            lambda topic=topic: (
                [endpoint["node"] for endpoint in theirs("endpoints", topic)] == ["/fleet/robot"] * 2
            ),
            what=topic,
        )
        expected = [
            ("PUBLISHER", "RELIABLE", "TRANSIENT_LOCAL"),
            ("SUBSCRIPTION", "BEST_EFFORT", "VOLATILE"),
        ]
        for found, (kind, reliability, durability) in zip(theirs("endpoints", topic), expected, strict=True):
            assert found["kind"] == kind
            assert found["type"] == message_class._TYPE_NAME
            assert message_class._TYPE_HASH in found["hash"] or same_hash(found["hash"], message_class)
            assert (found["reliability"], found["durability"]) == (reliability, durability)
        assert theirs("topics")[topic] == [message_class._TYPE_NAME]


@pytest.mark.row("topics, listed with types and hashes", direction=TO_US)
def test_topic_of_fast_dds_is_echoed_without_its_type(start_end: StartEnd) -> None:
    robot = start_robot(start_end, THEIRS)
    robot("publish", "p_text", "the last words")
    assert ros2("topic", "echo", "--once", "/words") == "data: the last words\n---\n"


def same_hash(text: str, message_class: Any) -> bool:
    """Return whether a hash that is printed in another form has the same digits."""
    return re.sub("[^0-9a-f]", "", text).endswith(message_class._TYPE_HASH.removeprefix("RIHS01_"))


@pytest.mark.row("listings in a row", direction=TO_US)
def test_listings_in_a_row_are_complete(start_end: StartEnd) -> None:
    start_robot(start_end, THEIRS)
    for _ in range(LISTINGS):
        assert ros2("node", "list").split() == ["/fleet/robot"]


@pytest.mark.row("listings in a row", direction=TO_US)
def test_listing_is_complete_after_the_first_process_was_killed(start_end: StartEnd) -> None:
    first = start_end(THEIRS, "first")
    start_robot(start_end, THEIRS)
    assert ros2("node", "list").split() == ["/first", "/fleet/robot"]
    os.kill(first.program.process.pid, 9)
    first.program.wait()
    for _ in range(3):
        assert "/fleet/robot" in ros2("node", "list").split()


@pytest.mark.row("nodes, listed", direction=TO_US)
@pytest.mark.parametrize("translated", ["1", "0"])
def test_doctor_names_each_vendor_and_what_passes(
    start_end: StartEnd, peer: RosPeer, monkeypatch: pytest.MonkeyPatch, translated: str
) -> None:
    start_end(THEIRS, "theirs")
    start_end(OURS, "ours")
    monkeypatch.setenv("TFLOOM_FASTDDS_SERVICES", translated)
    findings = {finding["check"]: finding for finding in json.loads(ros2("doctor", "--json"))}
    peers = findings["peers"]
    assert peers["verdict"] == ("ok" if translated == "1" else "warning")
    by_node = {re.findall(r"\((.*?)\)", text)[0]: text for text in peers["details"].values()}
    # Versions are read from the datagrams that the translation of services sees, too.
    version = r"\d+\.\d+\.\d+" if translated == "1" else "of unknown version"
    ours = rf"Cyclone DDS {version} \(/ours\); services: header in the message; all passes"
    assert re.fullmatch(ours, by_node["/ours"])
    # Fast DDS 2 does not announce its version.
    theirs = r"\d+(\.\d+)+" if translated == "1" and peer.release is KILTED else "of unknown version"
    assert re.match(rf"Fast DDS {theirs} \(/theirs\); services: inline QoS", by_node["/theirs"])
    assert ("all passes" in by_node["/theirs"]) == (translated == "1")
    assert ("/theirs" in peers["summary"]) == (translated == "0")
