"""Measure the messages a second that reach a Python callback, from a sender that is faster.

The sender is a process that writes serialized bytes on a reliable topic and waits for a slow receiver: tfloom's for
tfloom and cyclonedds, rclpy's own for rclpy. The CPU time of the receiving process for a message is measured too,
because it gives the rate on an idle machine with more cores.

Each message carries a number, and all of them have to arrive in order. Some are kept, and compared with what was sent
after the measured time.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from typing import Any, NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import APIS, BEFORE, PEER, background, cyclone_reader, run
from benchmarks.node.ros_trips import SIZES

COUNTS = {
    "1": {"tfloom": 60_000, "cyclonedds": 5_000, PEER: 10_000},
    "50": {"tfloom": 20_000, "cyclonedds": 200, PEER: 1_000},
    "64 kB": {"tfloom": 6_000, "cyclonedds": 50, PEER: 1_500},
    "1 MB": {"tfloom": 200, "cyclonedds": 5, PEER: 60},
}
"""Number of messages sent to each API."""
TURNS = 2
KEPT = 5
"""Number of messages that are compared as a whole."""
MAX_DURATION_S = 50.0


class Received(NamedTuple):
    per_second: float
    cpu_us: float
    """CPU time of a message."""


class Heard:
    """Counts the messages, keeps some, and measures the time from the first to the last of them."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._every = max(1, count // KEPT)
        self.heard = 0
        self.kept: list[Any] = []
        self.received: Received | None = None

    def __call__(self, message: Any, number: int) -> bool:
        """Take a message, and return whether it is the last.

        Raises:
            ValueError: a message is missing, or arrived twice.
        """
        self.heard += 1
        if number != self.heard:
            raise ValueError(f"message {number} arrived as the {self.heard}th")
        if number == 1:
            self._begin, self._cpu_begin = time.perf_counter(), time.process_time()
        if number % self._every == 0:
            self.kept.append(message)
        if number < self._count:
            return False
        elapsed, cpu = time.perf_counter() - self._begin, time.process_time() - self._cpu_begin
        self.received = Received((number - 1) / elapsed, cpu / (number - 1) * 1e6)
        return True


def ros(kind: str, count: int) -> Received:
    import rclpy
    from rclpy.qos import HistoryPolicy, QoSProfile

    from benchmarks.node.messages import numbered

    rclpy.init()
    node = rclpy.create_node("receiver")
    done: Any = rclpy.Future()
    heard = Heard(count)
    numbers = numbered(kind)

    def on_message(message: Any) -> None:
        if heard(message, numbers.number(message)):
            done.set_result(heard.received)

    qos = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    node.create_subscription(numbers.type, "/bench", on_message, qos)
    rclpy.spin_until_future_complete(node, done, timeout_sec=MAX_DURATION_S)
    if heard.received is None:
        raise TimeoutError(f"{heard.heard} of {count} messages arrived")
    for message in heard.kept:
        if message != numbers.message(numbers.number(message)):
            raise ValueError(f"message {numbers.number(message)} arrived with other content")
    return heard.received


def cyclonedds(kind: str, count: int) -> Received:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node import cyclone_types

    participant = DomainParticipant(DOMAIN_ID)
    message_type = cyclone_types.UInt8MultiArray if kind in SIZES else cyclone_types.TFMessage
    _, receive = cyclone_reader(participant, "rt/bench", message_type, depth=None)
    heard = Heard(count)

    def number_in(message: Any) -> int:
        return int(message.layout.data_offset if kind in SIZES else message.transforms[0].header.stamp.sec)

    while heard.received is None:
        for message in receive(100):
            heard(message, number_in(message))
    for message in heard.kept:
        number = number_in(message)
        if kind in SIZES:
            is_same = bytes(message.data) == bytes(range(256)) * (SIZES[kind] // 256)
        else:
            expected = cyclone_types.tf_message(int(kind), cyclone_types.Time(0, 0))
            expected.transforms[0].header.stamp = cyclone_types.Time(number, 0)
            is_same = message == expected
        if not is_same:
            raise ValueError(f"message {number} arrived with other content")
    return heard.received


def measure(kind: str, apis: Sequence[str] = APIS) -> dict[str, Received]:
    """Return the rate and the CPU time of each API: the best of some turns."""
    received: dict[str, list[Received]] = {api: [] for api in apis}
    for _ in range(TURNS):
        for api in apis:
            count = COUNTS[kind]["tfloom" if api == BEFORE else api]
            sender = PEER if api == PEER else "tfloom"
            with background("sender", "flood", kind, count, api=sender):
                received[api].append(Received(*run("receiving", api, kind, count, api=api)))
    return {
        api: Received(max(turn.per_second for turn in turns), min(turn.cpu_us for turn in turns))
        for api, turns in received.items()
    }


if __name__ == "__main__":
    receive_by = cyclonedds if sys.argv[1] == "cyclonedds" else ros
    print(json.dumps(receive_by(sys.argv[2], int(sys.argv[3]))))
