"""Measure nodes on loopback, between separate processes, beside cyclonedds' Python API in the same run.

The last columns are the figures of rclpy in a real ROS 2 Jazzy (rmw_cyclonedds, on a similar machine), and the aims. A
ratio above 1 means that tfloom is better by that factor.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from benchmarks.node import executors, listener, publishing, receiving, round_trip, start, timers

WIDTH = 52


def head(title: str) -> None:
    print(f"{title:<{WIDTH}}{'tfloom':>10}{'peer':>10}{'ratio':>7}{'rclpy':>8}{'aim':>8}", flush=True)


def row(
    what: str,
    ours: float,
    peers: float,
    *,
    is_more_better: bool = False,
    rclpy: str = "",
    aim: str = "",
) -> None:
    ratio = (ours / peers if is_more_better else peers / ours) if ours and peers else float("nan")
    print(
        f"  {what:<{WIDTH - 2}}{number(ours):>10}{number(peers):>10}{ratio:>7.1f}{rclpy:>8}{aim:>8}",
        flush=True,
    )


def number(value: float) -> str:
    return f"{value:,.0f}" if value >= 1000 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def round_trips() -> None:
    head("to another process and back [us]")
    references = {"String": (("158", "60"), ("267", "150"))}
    for kind in round_trip.TRIPS:
        times = round_trip.measure(kind)
        name = (
            "a service call" if kind == "service" else f"a message of {kind}" if " " in kind else f"a {kind}"
        )
        for index, percent in enumerate((50, 99)):
            rclpy, aim = references.get(kind, (("", ""),) * 2)[index]
            row(
                f"{name}, p{percent}",
                times["tfloom"][index],
                times["cyclonedds"][index],
                rclpy=rclpy,
                aim=aim,
            )


def messages_received() -> None:
    head("messages a second into a Python callback")
    references = {"1": ("8,400", "60,000"), "50": ("1,150", "15,000")}
    for kind in receiving.COUNTS:
        received = receiving.measure(kind)
        ours, peers = received["tfloom"], received["cyclonedds"]
        name = f"of {kind}" if " " in kind else f"TFMessage x {kind}"
        rclpy, aim = references.get(kind, ("", ""))
        row(name, ours.per_second, peers.per_second, is_more_better=True, rclpy=rclpy, aim=aim)
        row("  CPU of the receiver, a message [us]", ours.cpu_us, peers.cpu_us)


def messages_published() -> None:
    head("CPU a message published [us]")
    for transforms, rclpy, aim in ((1, "", ""), (50, "200-400", "25")):
        cost = publishing.measure(transforms)
        row(f"TFMessage x {transforms}", cost["tfloom"], cost["cyclonedds"], rclpy=rclpy, aim=aim)


def listeners() -> None:
    head("a TransformListener without lookups [% of a core]")
    for transforms, rate_hz, rclpy, aim in ((50, 100, "14", "0.7"), (1, 1000, "35", "2")):
        taken = listener.measure(transforms, rate_hz)
        for api, each in taken.items():
            if not 0.9 < each.rate_hz / rate_hz < 1.1:
                print(f"  {api} received {each.rate_hz:.0f} messages a second, not {rate_hz}: busy machine")
        ours = taken["tfloom"].percent
        name = f"{rate_hz} Hz x {transforms} transforms"
        row(name, ours, taken["cyclonedds"].percent, rclpy=rclpy, aim=aim)
        if "bare C++" in taken:
            row("  peer: a reader in C++ that drops all samples", ours, taken["bare C++"].percent)


def many_timers() -> None:
    head(f"{timers.TIMERS} timers at {1 / timers.PERIOD_S:.0f} Hz; peer: asyncio's")
    kept = timers.measure()
    for what, field in (("% of a core", "percent"), ("jitter, p50 [ms]", "p50_ms"), ("p99 [ms]", "p99_ms")):
        row(what, getattr(kept["tfloom"], field), getattr(kept["asyncio"], field))


def between_callbacks() -> None:
    head("CPU a callback, with its message [us]; peer: SingleThreaded")
    cost = executors.measure()
    for kind in ("EventsExecutor", "MultiThreadedExecutor"):
        row(kind, cost[kind], cost["SingleThreadedExecutor"])


def starts() -> None:
    head("a program's start")
    started = start.measure()
    ours, peers = started["tfloom"], started["cyclonedds"]
    row("import [ms]", ours.import_ms, peers.import_ms)
    row("init [ms]", ours.init_ms, peers.init_ms)
    row("first node; peer: participant [ms]", ours.node_ms, peers.node_ms)
    row("first publisher [ms]", ours.publisher_ms, peers.publisher_ms)
    row("CPU of all that [ms]", ours.cpu_ms, peers.cpu_ms)
    row("memory then, beyond Python's [MB]", ours.node_mb - ours.python_mb, peers.node_mb - peers.python_mb)


def idle() -> None:
    head("idle [% of a core]")
    share = start.measure_idle()
    row("a node; peer: a participant", share["node"], share["cyclonedds"])
    row("a TransformListener; peer: a participant", share["listener"], share["cyclonedds"])


PARTS: dict[str, Callable[[], None]] = {
    "trips": round_trips,
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
    for part in requested:
        PARTS[part]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
