"""Waits for tokens that may be busy: `benchmarks/native`, "busy wait", measures what they gain."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from statistics import median

import pytest

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Topic, Writer
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.qos import QoS

pytestmark = [
    pytest.mark.timing,
    pytest.mark.skipif(
        not hasattr(os, "sched_getaffinity") or len(os.sched_getaffinity(0)) < 2,
        reason="waits are busy on two processors or more, which are counted on Linux",
    ),
]
DATA = b"\0\1\0\0" + bytes(8)
WAITS = 300


@pytest.fixture
def writer(domain_id: int) -> Iterator[Writer]:
    participant = cyclonedds.open_participant(domain_id)
    node = NodeName("/", "sender")
    participant.add_node(node)
    yield participant.create_writer(node, Topic("/sent", "std_msgs/msg/UInt64", ""), QoS())
    participant.close()


def cpu_us_of_a_wait(timeout_ns: int, writer: Writer | None) -> float:
    """Return the median CPU time of a wait in vain, after a message was sent by `writer`, if any."""
    queue = ReadyQueue()
    times_ns = []
    for _ in range(WAITS):
        if writer is not None:
            writer.write(DATA)
        begin_ns = time.thread_time_ns()
        assert queue.wait(timeout_ns) == []
        times_ns.append(time.thread_time_ns() - begin_ns)
    return median(times_ns[WAITS // 3 :]) / 1e3


def test_long_waits_are_never_busy(writer: Writer) -> None:
    asleep = cpu_us_of_a_wait(2_000_000, None)
    assert cpu_us_of_a_wait(2_000_000, writer) < asleep + 40


def test_short_waits_in_vain_are_seldom_busy(writer: Writer) -> None:
    asleep = cpu_us_of_a_wait(300_000, None)
    assert cpu_us_of_a_wait(300_000, writer) < asleep + 40


def test_a_busy_wait_keeps_its_timeout(writer: Writer) -> None:
    queue = ReadyQueue()
    times_ns = []
    for _ in range(WAITS):
        writer.write(DATA)
        begin_ns = time.thread_time_ns()
        queue.wait(10_000)
        times_ns.append(time.thread_time_ns() - begin_ns)
    # CPU time, which others' work on the machine lengthens little. Without its timeout, a busy wait takes 250 µs, and
    # four in a row are busy before each of two or three pauses.
    assert sorted(times_ns)[-7] < 120_000
