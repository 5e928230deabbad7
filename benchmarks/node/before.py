"""Measure nodes before and after a change: `python -m benchmarks.node.before PYTHON [part ...]`.

PYTHON is the Python of an environment that has tfloom of another commit. Today's benchmarks run with both, in turn, so
that other load on the machine affects both. Prints a table in Markdown; a ratio above 1 means that the later one is
better by that factor.

The senders of `receiving` and `listener`, and the receiver of `publishing`, are of the later one in both cases.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterator

from benchmarks.node import executors, listener, publishing, receiving, round_trip, start, timers
from benchmarks.node.__main__ import number
from benchmarks.node.processes import BEFORE, BEFORE_VARIABLE
from benchmarks.node.ros_spinning import IN_A_THREAD
from benchmarks.node.ros_trips import SIZES

APIS = (BEFORE, "tfloom")
ROUNDS = 3
Row = tuple[str, float, float]
"""What was measured, and its values before and after, of which smaller ones are better."""


def smallest(measure: Callable[[str], dict[str, float]]) -> Iterator[Row]:
    """Yield a row for each value of `measure(api)`: the smallest of some rounds, in each of which both APIs run."""
    rounds = [[measure(api) for api in APIS] for _ in range(ROUNDS)]
    for name in rounds[0][0]:
        before, after = (min(values[index][name] for values in rounds) for index in range(len(APIS)))
        yield name, before, after


def trips() -> Iterator[Row]:
    for kind in ("String", *SIZES):
        yield from trip(f"a {kind} there and back", kind, "spin_once")


def services() -> Iterator[Row]:
    yield from trip("a service call by `call`", "service", "call")
    yield from trip("a service call by `call_async`", "service", "call_async")
    yield from trip("the first call of a new client", round_trip.FIRST_CALL, "call")


def spinning() -> Iterator[Row]:
    for way in IN_A_THREAD:
        yield from trip(f"a String there and back, {way} in a thread", "String", way)


def trip(name: str, kind: str, way: str) -> Iterator[Row]:
    measured = round_trip.measure(kind, way, APIS)
    before, after = (measured[api] for api in APIS)
    yield f"{name}, p50 [µs]", before.p50_us, after.p50_us
    yield f"{name}, p99 [µs]", before.p99_us, after.p99_us
    yield f"{name}: CPU of the answering process [µs]", before.cpu_us, after.cpu_us


def between_callbacks() -> Iterator[Row]:
    for name, before, after in smallest(executors.measure):
        yield f"CPU of a callback whose message waits, {name} [µs]", before, after


def kept_timers() -> Iterator[Row]:
    kept = timers.measure(APIS)
    if any(calls.share < timers.COMPLETE for calls in kept.values()):
        print("busy machine: timers were skipped", file=sys.stderr)
    before, after = (kept[api] for api in APIS)
    name = f"{timers.TIMERS:,} timers at 10 Hz"
    yield f"{name}, of a core [%]", before.percent, after.percent
    yield f"{name}: jitter, p50 [ms]", before.p50_ms, after.p50_ms
    yield f"{name}: jitter, p99 [ms]", before.p99_ms, after.p99_ms


def published() -> Iterator[Row]:
    for transforms in (1, 50):
        cost = publishing.measure(transforms, APIS)
        yield f"publishing `TFMessage` x {transforms}, CPU [µs]", cost[BEFORE], cost["tfloom"]


def received() -> Iterator[Row]:
    for kind in receiving.COUNTS:
        measured = receiving.measure(kind, APIS)
        before, after = (measured[api] for api in APIS)
        name = f"`TFMessage` x {kind}" if kind.isdigit() else kind
        yield f"into a callback, {name}, a message [µs]", 1e6 / before.per_second, 1e6 / after.per_second
        yield f"into a callback, {name}: CPU [µs]", before.cpu_us, after.cpu_us


def listeners() -> Iterator[Row]:
    for transforms, rate_hz in ((1, 1000), (50, 100)):
        taken = listener.measure(transforms, rate_hz, APIS)
        name = f"a `TransformListener`, {rate_hz} Hz x {transforms}, of a core [%]"
        yield name, taken[BEFORE].percent, taken["tfloom"].percent


def starts() -> Iterator[Row]:
    def measure(api: str) -> dict[str, float]:
        started = start.measure((api,))[api]
        return {
            "import, node and publisher, by the clock [ms]": started.import_ms
            + started.init_ms
            + started.node_ms
            + started.publisher_ms,
            "import, node and publisher, CPU [ms]": started.cpu_ms,
            "memory then, beyond Python's [MB]": started.node_mb - started.python_mb,
        }

    yield from smallest(measure)


def idle() -> Iterator[Row]:
    names = {
        "node": "a node",
        "listener": "a node with a `TransformListener`",
        "MultiThreadedExecutor": "a `MultiThreadedExecutor`",
    }
    rounds = [start.measure_idle(APIS) for _ in range(ROUNDS)]
    for what, name in names.items():
        before, after = (min(values[api, what] for values in rounds) for api in APIS)
        yield f"idle: {name}, of a core [%]", before, after


PARTS: dict[str, Callable[[], Iterator[Row]]] = {
    "trips": trips,
    "services": services,
    "spinning": spinning,
    "executors": between_callbacks,
    "timers": kept_timers,
    "publishing": published,
    "receiving": received,
    "listener": listeners,
    "start": starts,
    "idle": idle,
}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.before", description=__doc__)
    parser.add_argument(
        "python", metavar="PYTHON", help="the Python of the environment with the earlier tfloom"
    )
    parser.add_argument("parts", nargs="*", metavar="part", help=", ".join(PARTS))
    options = parser.parse_args()
    if unknown := [part for part in options.parts if part not in PARTS]:
        parser.error(f"there is no {', '.join(unknown)}; there are: {', '.join(PARTS)}")
    os.environ[BEFORE_VARIABLE] = options.python
    print("| | before | after | ratio |\n|---|---|---|---|")
    for part in options.parts or PARTS:
        for name, before, after in PARTS[part]():
            print(f"| {name} | {number(before)} | {number(after)} | {before / after:.2g} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
