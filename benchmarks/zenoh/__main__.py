"""Measure the wire on Zenoh beside the one on DDS, in turns: `python -m benchmarks.zenoh [--trips N] [--samples N]`.

Two processes on the loopback interface, 200 octets a sample unless a row names a size. The table has the medians of the
turns and ratios: on a loaded machine only these mean something. The library's own round trip, without tfloom, is the
least that one on Zenoh takes: its Python binding has a thread of the library and the GIL at each end.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from collections.abc import Callable
from statistics import median

from benchmarks.zenoh.peer import ALL, ANSWER, ASK, NODE, Bare
from tfloom._native import ReadyQueue
from tfloom.rmw.backends import is_installed, open_participant

WIRES = {"rmw_zenoh_cpp": "Zenoh", "rmw_cyclonedds_cpp": "Cyclone"}
TURNS = 3
OCTETS = 200
LARGE = {"1 MB": (1_000_000, 40), "8 MB": (8_000_000, 15)}
"""Octets, and trips in a turn."""
RATE_HZ = 1000.0
DOMAIN, PORT, BARE_PORT = "96", "30000", 30001
PATIENCE_S = 30.0


def start(*words: object) -> subprocess.Popen[str]:
    """Start a peer, and wait until it is ready."""
    command = [sys.executable, "-m", "benchmarks.zenoh.peer", *map(str, words)]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n", "the peer ended"
    return process


def trips_us(count: int, octets: int = OCTETS) -> tuple[float, float]:
    """Return p50 and p99 of round trips between two processes [us]."""
    peer = start("echo")
    participant = open_participant()
    try:
        participant.add_node(NODE)
        writer, reader = (
            participant.create_writer(NODE, ASK, ALL),
            participant.create_reader(NODE, ANSWER, ALL),
        )
        end = time.monotonic() + PATIENCE_S
        while not (writer.matched_count() and reader.matched_count()):
            assert time.monotonic() < end, "the peer isn't matched"
            time.sleep(0.01)
        queue = ReadyQueue()
        reader.notify(queue)
        return percentiles_us(count, octets, writer.write, reader.take, queue)
    finally:
        participant.close()
        peer.kill()
        peer.wait()


def bare_trips_us(count: int, octets: int = OCTETS) -> tuple[float, float]:
    """Return p50 and p99 of round trips by Zenoh's library alone [us]."""
    peer = start("bare", BARE_PORT)
    end = Bare(BARE_PORT, ("ask", "answer"), listens=False)
    try:
        limit = time.monotonic() + PATIENCE_S
        while not end.publisher.matching_status.matching:
            assert time.monotonic() < limit, "the peer isn't matched"
            time.sleep(0.01)
        return percentiles_us(count, octets, end.publisher.put, end.take, end.queue)
    finally:
        end.session.close()
        peer.kill()
        peer.wait()


def shared_trips_us() -> dict[str, float]:
    """Return p50 of round trips of large messages on Zenoh, where both ask for its shared memory [us], by row."""
    asked = {
        "RMW_IMPLEMENTATION": "rmw_zenoh_cpp",
        "ZENOH_CONFIG_OVERRIDE": "transport/shared_memory/enabled=true",
    }
    before = {name: os.environ.get(name) for name in asked}
    os.environ.update(asked)
    try:
        return {
            f"{name}, by its shared memory, p50": trips_us(count, octets)[0]
            for name, (octets, count) in LARGE.items()
        }
    finally:
        for name, value in before.items():
            os.environ.pop(name) if value is None else os.environ.update({name: value})


def percentiles_us(
    count: int, octets: int, write: Callable[[bytes], None], take: Callable[[], object], queue: ReadyQueue
) -> tuple[float, float]:
    """Return p50 and p99 of the times until what is written comes back [us]."""
    times = []
    for number in range(count):
        data = b"\0\1\0\0" + number.to_bytes(4, "little") + bytes(octets - 8)
        begun = time.perf_counter()
        write(data)
        while (answer := take()) is None:
            assert queue.wait(int(PATIENCE_S * 1e9)), "no echo"
        times.append((time.perf_counter() - begun) * 1e6)
        assert getattr(answer, "data", answer) == data, "another echo"
    times.sort()
    return times[count // 2], times[count * 99 // 100]


def stream_us(kind: str, count: int) -> tuple[float, float]:
    """Return the CPU time a sample [us] of a receiver, into a sink or by Python, and of the sender."""
    receiver, sender = start(kind, count), start("send", RATE_HZ, count)
    try:
        time.sleep(1.0)  # both have to know each other; neither tells
        for process in (receiver, sender):
            process.stdin.write("go\n")
            process.stdin.flush()
        times = float(receiver.stdout.readline()), float(sender.stdout.readline())
        sender.stdin.write("end\n")
        sender.stdin.flush()
        return times
    finally:
        for process in (receiver, sender):
            process.kill()
            process.wait()


def measure(trips: int, samples: int) -> dict[str, float]:
    """Return the numbers of one turn on the wire of the environment, by row."""
    p50, p99 = trips_us(trips)
    sink, sender = stream_us("sink", samples)
    python, _ = stream_us("callback", samples)
    large = {
        f"{name} there and back, p50": trips_us(count, octets)[0] for name, (octets, count) in LARGE.items()
    }
    return {
        "round trip, p50": p50,
        "round trip, p99": p99,
        "receiver's CPU, into a buffer (/tf)": sink,
        "receiver's CPU, taken by Python": python,
        "sender's CPU": sender,
        **large,
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--trips", type=int, default=2000)
    parser.add_argument("--samples", type=int, default=3000)
    args = parser.parse_args()
    os.environ.update(ROS_DOMAIN_ID=DOMAIN, TFLOOM_ZENOH_PORT=PORT, ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST")
    if missing := [text for name, text in WIRES.items() if not is_installed(name)]:
        print(f"not measured: {' and '.join(missing)} is not installed")
        return 0
    turns: dict[str, list[dict[str, float]]] = {name: [] for name in WIRES}
    others: list[dict[str, float]] = []
    for _ in range(TURNS):
        for name in WIRES:
            os.environ["RMW_IMPLEMENTATION"] = name
            turns[name].append(measure(args.trips, args.samples))
        p50, p99 = bare_trips_us(args.trips)
        alone = {
            f"of {name}, p50": bare_trips_us(count, octets)[0] for name, (octets, count) in LARGE.items()
        }
        alone = {
            f"by the library alone, {row}": value for row, value in {"p50": p50, "p99": p99, **alone}.items()
        }
        others.append(alone | shared_trips_us())
    zenoh, cyclone = turns.values()
    print(f"{'[us]':40}{'Zenoh':>10}{'Cyclone':>10}{'ratio':>8}")
    for row in zenoh[0]:
        ours, theirs = (median(turn[row] for turn in measured) for measured in (zenoh, cyclone))
        print(f"{row:40}{ours:10.1f}{theirs:10.1f}{ours / theirs:8.1f}")
    for row in others[0]:
        print(f"{row:40}{median(turn[row] for turn in others):10.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
