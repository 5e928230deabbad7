"""Measure the start of a program, and the cost of an idle node: time, memory, CPU."""

from __future__ import annotations

import contextlib
import itertools
import json
import sys
import time
from collections.abc import Callable, Sequence
from statistics import median
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import PEER, background, run

STARTS = 5
IDLE_S = 20.0
SETTLING_S = 1.0
"""Time of a program before it counts as idle."""
IDLE = ("node", "listener", "MultiThreadedExecutor")
"""What is idle: a node, a node with a TransformListener, a node in an executor with threads."""


class Started(NamedTuple):
    """Times of consecutive steps [ms]; resident memory (RSS) [MB]."""

    import_ms: float
    init_ms: float
    node_ms: float
    publisher_ms: float
    cpu_ms: float
    """CPU time of all steps."""
    python_mb: float
    node_mb: float


def resident_mb() -> float:
    """Return the resident memory of the process; NaN without /proc."""
    import os
    from pathlib import Path

    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return float("nan")
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def ros() -> Started:
    python_mb, cpu_begin, times = resident_mb(), time.process_time(), [time.perf_counter()]
    import rclpy

    times.append(time.perf_counter())
    rclpy.init()
    times.append(time.perf_counter())
    node = rclpy.create_node("started")
    times.append(time.perf_counter())
    from std_msgs.msg import String

    node.create_publisher(String, "bench", 10)
    times.append(time.perf_counter())
    return started(times, cpu_begin, python_mb)


def cyclonedds() -> Started:
    python_mb, cpu_begin, times = resident_mb(), time.process_time(), [time.perf_counter()]
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.pub import DataWriter
    from cyclonedds.topic import Topic

    times.append(time.perf_counter())
    times.append(time.perf_counter())
    participant = DomainParticipant(DOMAIN_ID)
    times.append(time.perf_counter())
    from benchmarks.node.cyclone_types import String

    writer = DataWriter(participant, Topic(participant, "rt/bench", String))
    times.append(time.perf_counter())
    del writer
    return started(times, cpu_begin, python_mb)


def started(times: list[float], cpu_begin: float, python_mb: float) -> Started:
    cpu_ms = (time.process_time() - cpu_begin) * 1e3
    return Started(
        *(round((end - begin) * 1e3, 3) for begin, end in itertools.pairwise(times)),
        cpu_ms,
        python_mb,
        resident_mb(),
    )


def idle(what: str) -> float:
    """Return the share of a core of a spinning node that receives nothing [%].

    Args:
        what: One of IDLE.
    """
    import rclpy

    rclpy.init()
    node = rclpy.create_node("idle")
    if what == "MultiThreadedExecutor":
        from benchmarks.node.ros_spinning import spinning

        with spinning(what, node):
            return idle_share(time.sleep)
    if what == "listener":
        from tf2_ros import Buffer, TransformListener

        TransformListener(Buffer(), node)
    return idle_share(
        lambda seconds: rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=seconds)
    )


def idle_cyclonedds() -> float:
    """Return the same for a participant in a program that sleeps."""
    from cyclonedds.domain import DomainParticipant

    participant = DomainParticipant(DOMAIN_ID)
    share = idle_share(time.sleep)
    del participant
    return share


def idle_share(pass_time: Callable[[float], object]) -> float:
    """Return the share of a core of this process [%] while `pass_time` passes so many seconds."""
    pass_time(SETTLING_S)
    begin, cpu_begin = time.perf_counter(), time.process_time()
    pass_time(IDLE_S)
    return (time.process_time() - cpu_begin) / (time.perf_counter() - begin) * 100


def measure(some: Sequence[str]) -> dict[str, Started]:
    """Return the medians of some starts of each API, each in a new process."""
    starts: dict[str, list[Started]] = {api: [] for api in some}
    for _ in range(STARTS):
        for api, started_by in starts.items():
            started_by.append(Started(*run("start", api, api=api)))
    return {api: Started(*map(median, zip(*rows, strict=True))) for api, rows in starts.items()}


def measure_idle(some: Sequence[str]) -> dict[tuple[str, str], float]:
    """Return the share of a core [%] of each idle program of each API: those of IDLE, of cyclonedds a participant.

    They run at the same time, because they do not interfere. The wheels of PEER have no TransformListener.
    """
    programs = [
        (api, what)
        for api in some
        for what in (("participant",) if api == "cyclonedds" else IDLE)
        if (api, what) != (PEER, "listener")
    ]
    with contextlib.ExitStack() as stack:
        processes = {
            (api, what): stack.enter_context(background("start", "idle", api, what, api=api))
            for api, what in programs
        }
        return {program: json.loads(process.communicate()[0]) for program, process in processes.items()}


def main() -> None:
    if sys.argv[1] == "idle":
        print(json.dumps(idle_cyclonedds() if sys.argv[2] == "cyclonedds" else idle(sys.argv[3])))
    else:
        print(json.dumps((cyclonedds if sys.argv[1] == "cyclonedds" else ros)()))


if __name__ == "__main__":
    main()
