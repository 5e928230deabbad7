"""Measure the round trip of 1 kB between two processes on loopback: tfloom's wire, and cyclonedds' Python API.

The two run in turns, so that other load on the machine affects both. Times are from the write to the receipt of the
reply. One sample is in flight: each carries a number, and the reply must be the sample that was sent.
"""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from statistics import median
from time import perf_counter_ns

from benchmarks.domain import DOMAIN_ID
from benchmarks.node import round_trip
from benchmarks.node.processes import wait_for
from tfloom.rmw.cyclone.config import configuration

PAYLOAD_SIZE = 1000
WARM_UP = 200
ROUND_TRIPS = 1000
TURNS = 5


def tfloom_ends(there: str, back: str) -> tuple[Callable[[bytes], None], Callable[[], bytes]]:
    """Return a function that sends on `there`, and one that waits for a sample on `back`."""
    from tfloom._native import ReadyQueue
    from tfloom.rmw.base import NodeName, Topic
    from tfloom.rmw.cyclone.wire import open_participant
    from tfloom.rmw.qos import QoS

    participant, node = open_participant(DOMAIN_ID), NodeName("/", "bench")
    writer = participant.create_writer(node, Topic(f"/{there}", "bench/msg/Bytes", ""), QoS())
    reader = participant.create_reader(node, Topic(f"/{back}", "bench/msg/Bytes", ""), QoS())
    queue = ReadyQueue()
    reader.notify(queue, 1)

    def receive() -> bytes:
        while (sample := reader.take()) is None:
            queue.wait(1_000_000_000)
        return sample.data

    wait_for(lambda: writer.matched_count() and reader.matched_count())
    return writer.write, receive


def cyclonedds_ends(there: str, back: str) -> tuple[Callable[[bytes], None], Callable[[], bytes]]:
    """Return the same for cyclonedds' readers, writers and waitsets, with a type of their own."""
    from benchmarks.node.cyclone_types import Payload

    writer, receive = round_trip.cyclonedds_ends(there, Payload, back, Payload)
    return lambda data: writer.write(Payload(data)), lambda: bytes(receive(1)[0].data)


ENDS = {"tfloom": tfloom_ends, "cyclonedds": cyclonedds_ends}


def answer(name: str) -> None:
    """Send each sample back, until the parent ends this process."""
    send, receive = ENDS[name](f"{name}_back", f"{name}_there")
    while True:
        send(receive())


def samples() -> Iterator[bytes]:
    """Yield samples that differ in their numbers."""
    header, padding = b"\0\1\0\0", os.urandom(PAYLOAD_SIZE - 8)
    for number in itertools.count():
        yield header + number.to_bytes(8, "little") + padding


def trips_us(
    send: Callable[[bytes], None], receive: Callable[[], bytes], sent: Iterator[bytes], count: int
) -> list[float]:
    """Return the times of trips.

    Raises:
        RuntimeError: another sample arrived than the one that was sent.
    """
    times = []
    for data in itertools.islice(sent, count):
        start = perf_counter_ns()
        send(data)
        received = receive()
        times.append((perf_counter_ns() - start) / 1e3)
        if received != data:
            raise RuntimeError("the reply is another sample than the one that was sent")
    return times


def main() -> None:
    os.environ["CYCLONEDDS_URI"] = configuration()
    sent = samples()
    partners = [subprocess.Popen([sys.executable, "-m", "benchmarks.rmw", name]) for name in ENDS]
    try:
        ends = {name: open_ends(f"{name}_there", f"{name}_back") for name, open_ends in ENDS.items()}
        for send, receive in ends.values():
            trips_us(send, receive, sent, WARM_UP)
        times: dict[str, list[float]] = {name: [] for name in ENDS}
        for _ in range(TURNS):
            for name, (send, receive) in ends.items():
                times[name] += trips_us(send, receive, sent, ROUND_TRIPS)
    finally:
        for partner in partners:
            partner.kill()
            partner.wait()
    report(times)


def report(times: dict[str, list[float]]) -> None:
    print(f"round trip of {PAYLOAD_SIZE} octets, {len(times['tfloom'])} trips each [us]")
    p50 = {name: median(values) for name, values in times.items()}
    p99 = {name: round_trip.percentile(values, 99) for name, values in times.items()}
    for name in times:
        print(f"  {name:12} p50 {p50[name]:7.1f}   p99 {p99[name]:7.1f}")
    print(
        f"  cyclonedds / tfloom: p50 {p50['cyclonedds'] / p50['tfloom']:.1f}, "
        f"p99 {p99['cyclonedds'] / p99['tfloom']:.1f}"
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        answer(sys.argv[1])
    else:
        main()
