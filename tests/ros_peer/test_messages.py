"""Large messages, and many: all arrive, in order, with the octets that were sent."""

from __future__ import annotations

import json
import os
import sys
import time
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program
from tools.ros_peer import PROFILE, RosPeer

from .conftest import FROM_US, OURS, THEIRS, Ends, StartEnd, vendors

pytestmark = pytest.mark.ros

MEGABYTE = 1_000_000
LARGE_S = 180.0
"""Longest wait for large messages, which take minutes where other work occupies the processors."""
SIZES = (MEGABYTE, 8 * MEGABYTE)
RECEIVE_BUFFER = 4 << 20
"""What a receiver of bursts asks of the kernel, which grants at most net.core.rmem_max [octets]."""
COUNT = 20_000
HZ = 1000.0

MANAGED = """
import sys, rclpy
from rclpy.lifecycle import LifecycleNode

rclpy.init(args=sys.argv)
node = LifecycleNode(sys.argv[1])

def walk():
    node.trigger_configure()
    node.trigger_cleanup()

node.create_timer(0.1, walk)
rclpy.spin(node)
"""
LISTEN = """
import json, time, rclpy
from lifecycle_msgs.msg import TransitionEvent

begin = time.time()
counts = {"no time": 0, "now": 0, "wrong": 0}

def hear(event):
    stamp = getattr(event, "stamp", None)
    ns = event.timestamp if stamp is None else stamp.sec * 10**9 + stamp.nanosec
    kind = "no time" if ns == 0 else "now" if begin - 60 < ns / 1e9 < time.time() + 1 else "wrong"
    counts[kind if event.goal_state.label else "wrong"] += 1
    print(json.dumps(counts), flush=True)

rclpy.init()
node = rclpy.create_node("listens")
node.create_subscription(TransitionEvent, "/events", hear, 10)
rclpy.spin(node)
"""
"""Prints how many events it has heard of which times: the real rclpy sends none, so that it is 0."""


def is_in_order(numbers: list[Any]) -> bool:
    return numbers == list(range(len(numbers)))


def octets(number: int, size: int) -> list[int]:
    """Return what the end reads of a message."""
    data = (bytes(range(256)) * (size // 256 + 1))[number % 256 :][:size]
    return [number, size, zlib.crc32(data)]


@pytest.mark.row("1 MB and 8 MB, reliable")
@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size // MEGABYTE} MB")
def test_all_large_messages_arrive(new_ends: Ends, size: int, wait_until: Callable[..., None]) -> None:
    new_ends.reader("subscription", "large", "octets", "/large", {"depth": 5})
    new_ends.writer("publisher", "large", "octets", "/large", {"depth": 5})
    wait_until(lambda: all(end("matches", "large") == 1 for end in new_ends), what="a match")
    # A small message first, because a large one may be lost until the first heartbeat, some ms after the match
    # (docs/beside_ros2.md).
    sent = [[0, 100]] + [[number, size] for number in range(1, 6)]
    new_ends.writer("publish", "large", sent[0])
    wait_until(lambda: new_ends.reader("count", "large") == 1, what="the first message")
    new_ends.writer("publish", "large", *sent[1:])
    wait_until(lambda: new_ends.reader("count", "large") == len(sent), LARGE_S, "all messages")
    assert new_ends.reader("received", "large") == [octets(*written) for written in sent]


@pytest.fixture
def best_effort_ends(start_end: StartEnd, peer: RosPeer, direction: str, tmp_path: Path) -> Ends:
    """Return new ends, of which that of Fast DDS asks for a receive buffer that holds a message."""
    most = int(Path("/proc/sys/net/core/rmem_max").read_text("ascii"))
    if most < RECEIVE_BUFFER:
        pytest.skip(f"a burst of 8 MB needs net.core.rmem_max = {RECEIVE_BUFFER}, and here it is {most}")
    text = PROFILE.read_text("utf-8")
    place = "<maxInitialPeersRange>"
    assert place in text
    profile = tmp_path / "profile.xml"
    profile.write_text(
        text.replace(place, f"<receiveBufferSize>{RECEIVE_BUFFER}</receiveBufferSize>{place}"), "utf-8"
    )
    started = []
    for vendor, name in zip(vendors(direction), ("the_writer", "the_reader"), strict=True):
        variables = {peer.release.profile_variable: str(profile)} if vendor == THEIRS else {}
        started.append(start_end(vendor, name, **variables))
    return Ends(*started)


@pytest.mark.row("1 MB and 8 MB, best effort")
@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size // MEGABYTE} MB")
def test_large_messages_arrive_whole_or_not_at_all(
    best_effort_ends: Ends, size: int, wait_until: Callable[..., None]
) -> None:
    """Best effort may lose any message, so one of many must arrive, and all that do must be whole."""
    ends = best_effort_ends
    quality = {"depth": 5, "reliability": "BEST_EFFORT"}
    ends.reader("subscription", "large", "octets", "/large", quality)
    ends.writer("publisher", "large", "octets", "/large", quality)
    wait_until(lambda: all(end("matches", "large") == 1 for end in ends), what="a match")
    number = 0

    def is_received() -> bool:
        nonlocal number
        ends.writer("publish", "large", [number, size])
        number += 1
        return bool(ends.reader("count", "large") >= 3)

    wait_until(is_received, LARGE_S, "three messages")
    received = ends.reader("received", "large")
    assert received == [octets(got, size) for got, _, _ in received]
    assert received == sorted(received)


@pytest.mark.row("1 MB and 8 MB, best effort", direction=FROM_US)
def test_paced_messages_arrive_with_the_stock_receive_buffer(
    start_end: StartEnd, wait_until: Callable[..., None]
) -> None:
    """Unpaced, one of ten messages of 8 MB arrives at most: a stock socket holds three of their datagrams."""
    writer, reader = (
        start_end(vendor, name) for vendor, name in ((OURS, "the_writer"), (THEIRS, "the_reader"))
    )
    quality = {"depth": 5, "reliability": "BEST_EFFORT"}
    reader("subscription", "large", "octets", "/large", quality)
    writer("publisher", "large", "octets", "/large", quality)
    wait_until(lambda: writer("matches", "large") == reader("matches", "large") == 1, what="a match")
    sent = 0

    def is_shown() -> bool:
        nonlocal sent
        writer("publish", "large", [sent, 8 * MEGABYTE])
        sent += 1
        return sent >= 20 and reader("count", "large") * 4 >= sent

    wait_until(is_shown, LARGE_S, "a quarter of the messages")
    received = reader("received", "large")
    assert received == [octets(got, size) for got, size, _ in received]


@pytest.mark.row("20,000 messages at 1 kHz")
def test_no_message_of_many_is_lost(new_ends: Ends, wait_until: Callable[..., None]) -> None:
    quality = {"depth": COUNT}  # on a busy machine a reader may stall for seconds, and must replace nothing
    new_ends.reader("subscription", "many", "number", "/many", quality)
    new_ends.writer("publisher", "many", "number", "/many", quality)
    wait_until(lambda: all(end("matches", "many") == 1 for end in new_ends), what="a match")
    new_ends.writer("stream", "many", HZ, COUNT)

    def are_all_received() -> bool:
        time.sleep(0.5)  # rarely asked, because each answer takes time from the reader
        return bool(new_ends.reader("count", "many") >= COUNT)

    wait_until(are_all_received, 180.0, f"{COUNT} messages")
    assert is_in_order(new_ends.reader("received", "many"))


def test_events_of_lifecycle_nodes_of_both_forms_are_read_from_one_topic(
    peer: RosPeer,
    domain_id: int,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    """The real rclpy's, and tfloom's as of Lyrical, under each; the real one reads those of its own form."""
    onto_events = ("--ros-args", "-r", "~/transition_event:=/events")
    theirs = peer.environment(domain_id, ROS_LOG_DIR=os.environ["ROS_LOG_DIR"])
    start_program(peer.python, "-c", MANAGED, "theirs", *onto_events, env=theirs)
    ours = start_program(
        *(sys.executable, "-c", MANAGED, "ours", *onto_events), env=os.environ | {"ROS_DISTRO": "lyrical"}
    )

    def last(listener: Program) -> dict[str, int]:
        lines = [line for line in listener.lines if line.startswith("{")]
        return json.loads(lines[-1]) if lines else {"no time": 0, "now": 0, "wrong": 0}

    readers = [
        start_program(sys.executable, "-c", LISTEN, env=os.environ | {"ROS_DISTRO": name})
        for name in ("jazzy", "kilted", "lyrical")
    ]
    wait_until(lambda: all(min(last(each)["no time"], last(each)["now"]) > 3 for each in readers), 60)
    assert [last(each)["wrong"] for each in readers] == [0, 0, 0]
    ours.process.kill()
    ours.wait()
    start_program(
        *(sys.executable, "-c", MANAGED, "older", *onto_events),
        env=os.environ | {"ROS_DISTRO": peer.release.name},
    )
    their_reader = start_program(peer.python, "-c", LISTEN, env=theirs)
    wait_until(lambda: min(last(their_reader)["no time"], last(their_reader)["now"]) > 3, 60)
    assert last(their_reader)["wrong"] == 0
