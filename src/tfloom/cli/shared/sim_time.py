"""The time for `--use-sim-time`: the last one on /clock."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tfloom._native import ReadyQueue
from tfloom.cli.shared.listen import decoded
from tfloom.common.terminal import report
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of

NowNs = Callable[[], int]
"""A function that returns the time [ns]; 0 before it is known."""

PATIENCE_S = 1.0
"""Wait for the time before the user gets a message about it [s]."""


@contextmanager
def clock(participant: Participant, node: NodeName, *, simulated: bool) -> Iterator[NowNs]:
    """Yield a function that returns the time: this machine's, or the one on /clock."""
    if not simulated:
        yield time.time_ns
        return
    topic = topic_of(Clock, "/clock")
    reader = participant.create_reader(node, topic, QoS(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
    last_ns = 0

    def now_ns() -> int:
        nonlocal last_ns
        while sample := reader.take():
            if (message := decoded(Clock, sample)) is not None:
                last_ns = message.clock.sec * 1_000_000_000 + message.clock.nanosec
        return last_ns

    try:
        yield now_ns
    finally:
        reader.close()


def wait_until_known(now_ns: NowNs) -> None:
    """Wait for the first time on /clock; print a line if that takes long."""
    report_s = time.monotonic() + PATIENCE_S
    queue = ReadyQueue()
    while now_ns() == 0:
        if time.monotonic() >= report_s:
            report("waiting for the time on /clock")
            report_s = float("inf")
        queue.wait(10_000_000)
