"""Measure nodes on loopback, between separate processes, beside their peers in the same run.

The peers are the real rclpy on Fast DDS, if `make ros-peer` has installed it, and cyclonedds' Python API. A ratio above
1 means that tfloom is better by that factor; the last column is the aim for the ratio to rclpy.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable

from benchmarks.node import executors, listener, publishing, receiving, round_trip, start, streams, timers
from benchmarks.node.processes import PEER, apis
from benchmarks.node.ros_spinning import IN_A_THREAD
from benchmarks.node.ros_trips import SIZES, WAYS_TO_CALL

WIDTH = 52


def head(title: str, other: str = "cyclonedds") -> None:
    print(
        f"{title:<{WIDTH}}{'tfloom':>10}{'rclpy':>10}{'ratio':>7}{other:>15}{'ratio':>7}{'aim':>6}",
        flush=True,
    )


def row(
    what: str,
    ours: float,
    others: float = math.nan,
    rclpy: float = math.nan,
    *,
    is_more_better: bool = False,
    aim: str = "",
) -> None:
    def ratio(theirs: float) -> str:
        if math.isnan(theirs) or not ours or not theirs:
            return "-"
        return f"{ours / theirs if is_more_better else theirs / ours:.1f}"

    print(
        f"  {what:<{WIDTH - 2}}{number(ours):>10}{number(rclpy):>10}{ratio(rclpy):>7}"
        f"{number(others):>15}{ratio(others):>7}{aim:>6}",
        flush=True,
    )


def number(value: float) -> str:
    if math.isnan(value):
        return "-"
    return f"{value:,.0f}" if value >= 1000 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def round_trips() -> None:
    head("to another process and back, one in flight [us]")
    for kind in ("String", *SIZES):
        name = f"a message of {kind}" if kind in SIZES else f"a {kind}"
        trip_rows(name, round_trip.measure(kind, "spin_once", apis()), aim="5" if kind == "String" else "")
    for way in WAYS_TO_CALL:
        some = apis("example_interfaces")
        if way == "call":
            some = tuple(api for api in some if api != "cyclonedds")
        trip_rows(f"a service call by {way}", round_trip.measure("service", way, some), aim="4")
    some = tuple(api for api in apis("example_interfaces") if api != "cyclonedds")
    trip_rows("the first call of a new client", round_trip.measure(round_trip.FIRST_CALL, "call", some))


def trip_rows(name: str, trips: dict[str, round_trip.Trip], aim: str = "") -> None:
    none = round_trip.Trip(math.nan, math.nan, math.nan)
    ours, rclpy, cyclone = (trips.get(api, none) for api in ("tfloom", PEER, "cyclonedds"))
    row(f"{name}, p50", ours.p50_us, cyclone.p50_us, rclpy.p50_us, aim=aim)
    row(f"{name}, p99", ours.p99_us, cyclone.p99_us, rclpy.p99_us, aim=aim)
    row("  CPU of the answering process, a trip", ours.cpu_us, cyclone.cpu_us, rclpy.cpu_us)


def large_streams() -> None:
    for buffer, count in streams.BUFFERS.items():
        head(f"{count} messages at 30 Hz, best effort, sockets of {buffer}", "rclpy by UDP")
        for name, size in streams.SIZES.items():
            done = streams.measure_all(apis(), size, buffer)
            stream_row(
                f"received, of {name}", done, lambda stream: stream.received.messages, is_more_better=True
            )
            row("  sent without waiting for room", done["unpaced"].received.messages)
            stream_row("  CPU of the sender, a message [ms]", done, lambda stream: stream.sent.cpu_ms)
            stream_row("  CPU of the receiver, a message [ms]", done, lambda stream: stream.received.cpu_ms)
            stream_row("  peak memory of the sender [MB]", done, lambda stream: stream.sent.peak_mb)
            stream_row("  peak memory of the receiver [MB]", done, lambda stream: stream.received.peak_mb)


def stream_row(
    what: str,
    done: dict[str, streams.Stream],
    figure: Callable[[streams.Stream], float],
    *,
    is_more_better: bool = False,
) -> None:
    ours, rclpy, by_udp = (
        figure(done[api]) if api in done else math.nan for api in ("tfloom", PEER, "by UDP")
    )
    row(what, ours, by_udp, rclpy, is_more_better=is_more_better)


def ways_to_spin() -> None:
    head("a String there and back, by the executor [us]")
    for way in IN_A_THREAD:
        some = tuple(api for api in apis() if api != "cyclonedds")
        if way == "EventsExecutor":
            some = ("tfloom",)  # that of rclpy 7.1.6 stops responding
        trip_rows(f"{way}, in a thread", round_trip.measure("String", way, some))


def messages_received() -> None:
    head("messages a second into a Python callback")
    for kind in receiving.COUNTS:
        received = receiving.measure(kind, apis("tf2_msgs"))
        none = receiving.Received(math.nan, math.nan)
        ours, peers, rclpy = received["tfloom"], received["cyclonedds"], received.get(PEER, none)
        name = f"of {kind}" if " " in kind else f"TFMessage x {kind}"
        row(name, ours.per_second, peers.per_second, rclpy.per_second, is_more_better=True)
        row("  CPU of the receiver, a message [us]", ours.cpu_us, peers.cpu_us, rclpy.cpu_us)


def messages_published() -> None:
    head("CPU a message published [us]")
    for transforms in (1, 50):
        cost = publishing.measure(transforms, apis("tf2_msgs"))
        row(f"TFMessage x {transforms}", cost["tfloom"], cost["cyclonedds"], cost.get(PEER, math.nan))


def listeners() -> None:
    head("a TransformListener without lookups [% of a core]")
    for transforms, rate_hz in ((50, 100), (1, 1000)):
        taken = listener.measure(transforms, rate_hz, apis("tf2_msgs"))
        for api, rate in taken.items():
            if not 0.9 < rate.rate_hz / rate_hz < 1.1:
                print(f"  {api} received {rate.rate_hz:.0f} messages a second, not {rate_hz}: busy machine")
        ours = taken["tfloom"].percent
        name = f"{rate_hz} Hz x {transforms} transforms"
        rclpy = taken[PEER].percent if PEER in taken else math.nan
        row(name, ours, taken["cyclonedds"].percent, rclpy)
        if "bare C++" in taken:
            row("  peer: a reader in C++ that drops all samples", ours, taken["bare C++"].percent)


def many_timers() -> None:
    head(f"{timers.TIMERS} timers at {1 / timers.PERIOD_S:.0f} Hz", "asyncio")
    kept = timers.measure(["tfloom", "asyncio", *({PEER} & set(apis()))])
    for api, calls in kept.items():
        if calls.share < timers.COMPLETE:
            print(f"  {api} made {calls.share:.0%} of the calls that were due: busy machine")
    none = timers.Kept(*[math.nan] * len(timers.Kept._fields))
    ours, peers, rclpy = kept["tfloom"], kept["asyncio"], kept.get(PEER, none)
    row("% of a core", ours.percent, peers.percent, rclpy.percent)
    row("jitter, p50 [ms]", ours.p50_ms, peers.p50_ms, rclpy.p50_ms)
    row("p99 [ms]", ours.p99_ms, peers.p99_ms, rclpy.p99_ms)


def between_callbacks() -> None:
    head("CPU a callback, with its message [us]", "SingleThreaded")
    cost = executors.measure()
    for kind in ("EventsExecutor", "MultiThreadedExecutor"):
        row(kind, cost[kind], cost["SingleThreadedExecutor"])


def starts() -> None:
    head("a program's start")
    started = start.measure(apis())
    ours, peers = started["tfloom"], started["cyclonedds"]
    rclpy = started.get(PEER, start.Started(*[math.nan] * len(start.Started._fields)))
    row("import [ms]", ours.import_ms, peers.import_ms, rclpy.import_ms)
    row("init [ms]", ours.init_ms, peers.init_ms, rclpy.init_ms)
    row("first node; cyclonedds: participant [ms]", ours.node_ms, peers.node_ms, rclpy.node_ms)
    row("first publisher [ms]", ours.publisher_ms, peers.publisher_ms, rclpy.publisher_ms)
    row("CPU of all that [ms]", ours.cpu_ms, peers.cpu_ms, rclpy.cpu_ms)
    memory = (sizes.node_mb - sizes.python_mb for sizes in (ours, peers, rclpy))
    row("memory then, beyond Python's [MB]", *memory)


def idle() -> None:
    head("idle [% of a core]")
    share = start.measure_idle(apis())
    participant = share["cyclonedds", "participant"]
    for what in start.IDLE:
        name = f"a {what}; cyclonedds: a participant"
        row(name, share["tfloom", what], participant, share.get((PEER, what), math.nan))


PARTS: dict[str, Callable[[], None]] = {
    "trips": round_trips,
    "streams": large_streams,
    "spinning": ways_to_spin,
    "receiving": messages_received,
    "publishing": messages_published,
    "listener": listeners,
    "timers": many_timers,
    "executors": between_callbacks,
    "start": starts,
    "idle": idle,
}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node", description=__doc__)
    parser.add_argument("parts", nargs="*", metavar="part", help=", ".join(PARTS))
    requested = parser.parse_args().parts or list(PARTS)
    if unknown := [part for part in requested if part not in PARTS]:
        parser.error(f"there is no {', '.join(unknown)}; there are: {', '.join(PARTS)}")
    if PEER not in apis():
        print(
            "rclpy is not measured, because it is not installed: `make ros-peer` installs it, or names the reason"
        )
    for part in requested:
        PARTS[part]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
