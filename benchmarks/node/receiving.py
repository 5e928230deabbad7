"""Measure the messages a second that reach a Python callback, from a sender that is faster.

The sender is the same for both APIs: a process that writes serialized bytes on a reliable topic and waits for a slow
receiver. The CPU time of the receiving process for a message is measured too, because it gives the rate on an idle
machine with more cores.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any, NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.messages import SIZES
from benchmarks.node.processes import (
    APIS,
    background,
    cyclone_reader,
    run,
)

COUNTS = {"1": (60_000, 5_000), "50": (20_000, 200), "64 kB": (6_000, 50), "1 MB": (200, 5)}
"""Number of messages sent to tfloom, and to cyclonedds."""
TURNS = 2


class Received(NamedTuple):
    per_second: float
    cpu_us: float
    """CPU time of a message."""


class Stopwatch:
    """Measures from the first message to the last."""

    def start(self) -> None:
        self._begin, self._cpu_begin = time.perf_counter(), time.process_time()

    def stop(self, count: int) -> Received:
        elapsed, cpu = time.perf_counter() - self._begin, time.process_time() - self._cpu_begin
        return Received(count / elapsed, cpu / count * 1e6)


def tfloom(kind: str, count: int) -> Received:
    import rclpy
    from rclpy.qos import HistoryPolicy, QoSProfile
    from std_msgs.msg import UInt8MultiArray
    from tf2_msgs.msg import TFMessage

    rclpy.init()
    node = rclpy.create_node("receiver")
    done: Any = rclpy.Future()
    stopwatch = Stopwatch()
    heard = 0

    def on_message(_: Any) -> None:
        nonlocal heard
        heard += 1
        if heard == 1:
            stopwatch.start()
        elif heard == count:
            done.set_result(stopwatch.stop(count - 1))

    kind_of_message = UInt8MultiArray if kind in SIZES else TFMessage
    qos = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    node.create_subscription(kind_of_message, "/bench", on_message, qos)
    rclpy.spin_until_future_complete(node, done, timeout_sec=30.0)
    return done.result()


def cyclonedds(kind: str, count: int) -> Received:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node import cyclone_types

    participant = DomainParticipant(DOMAIN_ID)
    message_type = cyclone_types.UInt8MultiArray if kind in SIZES else cyclone_types.TFMessage
    _, receive = cyclone_reader(participant, "rt/bench", message_type, depth=None)
    stopwatch = Stopwatch()
    heard = 0
    while heard < count:
        for _ in receive(100):
            if not heard:
                stopwatch.start()
            heard += 1
    return stopwatch.stop(heard - 1)


def measure(kind: str) -> dict[str, Received]:
    """Return the rate and the CPU time of each API: the best of some turns."""
    received: dict[str, list[Received]] = {api: [] for api in APIS}
    for _ in range(TURNS):
        for api, count in zip(APIS, COUNTS[kind], strict=True):
            with background("sender", "flood", kind, count):
                received[api].append(Received(*run("receiving", api, kind, count)))
    return {
        api: Received(max(turn.per_second for turn in turns), min(turn.cpu_us for turn in turns))
        for api, turns in received.items()
    }


if __name__ == "__main__":
    receive_by = {"tfloom": tfloom, "cyclonedds": cyclonedds}[sys.argv[1]]
    print(json.dumps(receive_by(sys.argv[2], int(sys.argv[3]))))
