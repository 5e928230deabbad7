"""Measure the start of a program, and the cost of an idle node: time, memory, CPU."""

from __future__ import annotations

import contextlib
import itertools
import json
import sys
import time
from statistics import median
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import APIS, background, run

STARTS = 5
IDLE_S = 5.0


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


def tfloom() -> Started:
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
    """Return the share of a core of a spinning node that receives nothing [%]."""
    import rclpy

    rclpy.init()
    node = rclpy.create_node("idle")
    if what == "listener":
        from tf2_ros import Buffer, TransformListener

        TransformListener(Buffer(), node)
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=0.5)
    begin = time.process_time()
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=IDLE_S)
    return (time.process_time() - begin) / IDLE_S * 100


def idle_cyclonedds() -> float:
    """Return the same for a participant in a program that sleeps."""
    from cyclonedds.domain import DomainParticipant

    participant = DomainParticipant(DOMAIN_ID)
    time.sleep(0.5)
    begin = time.process_time()
    time.sleep(IDLE_S)
    share = (time.process_time() - begin) / IDLE_S * 100
    del participant
    return share


def measure() -> dict[str, Started]:
    """Return the medians of some starts of each API, each in a new process."""
    starts: dict[str, list[Started]] = {api: [] for api in APIS}
    for _ in range(STARTS):
        for api in APIS:
            starts[api].append(Started(*run("start", api)))
    return {api: Started(*map(median, zip(*rows, strict=True))) for api, rows in starts.items()}


def measure_idle() -> dict[str, float]:
    """Return the shares of a core of an idle node, an idle listener and an idle participant [%]."""
    names = ("node", "listener", "cyclonedds")
    processes = {}
    with contextlib.ExitStack() as stack:  # at the same time: idle processes do not interfere
        for name in names:
            processes[name] = stack.enter_context(background("start", "idle", name))
        return {name: json.loads(process.communicate()[0]) for name, process in processes.items()}


def main() -> None:
    if sys.argv[1] == "idle":
        print(json.dumps(idle_cyclonedds() if sys.argv[2] == "cyclonedds" else idle(sys.argv[2])))
    else:
        print(json.dumps({"tfloom": tfloom, "cyclonedds": cyclonedds}[sys.argv[1]]()))


if __name__ == "__main__":
    main()
