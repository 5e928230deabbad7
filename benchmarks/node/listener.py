"""Measure the share of a core of a TransformListener without lookups, beside a reader in C++.

The reader, `bare_reader.cpp`, drops all samples, so it is the lower limit for a listener on this library. On
cyclonedds' side, a loop reads the messages, and stores nothing.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import background, cyclone_reader, run, wait_for
from benchmarks.node.sender import FIRST_STAMP_NS
from tfloom.rmw.cyclone_config import configuration
from tfloom.rmw.cyclone_library import find_library

HERE = Path(__file__).parent
NATIVE = HERE.parent.parent / "native"
WARM_UP_S = 0.3
MEASURED_S = 2.0
TURNS = 2


class Taken(NamedTuple):
    percent: float
    """CPU time of the process, with all threads [% of a core]."""
    rate_hz: float
    """Rate of the messages received meanwhile."""


def tfloom() -> Taken:
    import rclpy
    from tf2_ros import Buffer, TransformListener

    rclpy.init()
    node = rclpy.create_node("listener")
    buffer = Buffer()
    TransformListener(buffer, node)
    wait_for(lambda: buffer.can_transform("base", "joint_0", rclpy.time.Time()))

    def spin(seconds: float) -> None:
        rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=seconds)

    def newest_ns() -> int:
        stamp = buffer.lookup_transform("base", "joint_0", rclpy.time.Time()).header.stamp
        return stamp.sec * 1_000_000_000 + stamp.nanosec

    spin(WARM_UP_S)
    first_ns, begin, cpu_begin = newest_ns(), time.monotonic(), time.process_time()
    spin(MEASURED_S)
    cpu, elapsed, passed_ns = (
        time.process_time() - cpu_begin,
        time.monotonic() - begin,
        newest_ns() - first_ns,
    )
    period_ns = int(sys.argv[2])
    assert first_ns >= FIRST_STAMP_NS
    return Taken(cpu / elapsed * 100, passed_ns / period_ns / elapsed)


def cyclonedds() -> Taken:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node import cyclone_types

    participant = DomainParticipant(DOMAIN_ID)
    _, receive = cyclone_reader(participant, "rt/tf", cyclone_types.TFMessage, depth=100)

    def spin(seconds: float) -> int:
        end, count = time.monotonic() + seconds, 0
        while time.monotonic() < end:
            count += len(receive(100))
        return count

    spin(WARM_UP_S)
    begin, cpu_begin = time.monotonic(), time.process_time()
    count = spin(MEASURED_S)
    elapsed = time.monotonic() - begin
    return Taken((time.process_time() - cpu_begin) / elapsed * 100, count / elapsed)


def compile_bare_reader(folder: str) -> str | None:
    """Return the path of the program; None without a compiler."""
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        return None
    sources = [
        NATIVE / "dds" / f"{name}.cpp" for name in ("library", "participant", "qos", "endpoint", "feeder")
    ]
    program = f"{folder}/bare_reader"
    flags = ["-std=c++20", "-O2", f"-I{NATIVE}", "-pthread", "-o", program]
    subprocess.run([compiler, *flags, HERE / "bare_reader.cpp", *sources, "-ldl"], check=True)
    return program


def run_bare_reader(program: str) -> Taken:
    arguments = [find_library(), str(DOMAIN_ID), configuration(), str(WARM_UP_S), str(MEASURED_S)]
    printed = subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout
    percent, rate_hz = printed.split()
    return Taken(float(percent), float(rate_hz))


def measure(transforms: int, rate_hz: int) -> dict[str, Taken]:
    """Return the CPU time and rate of each: the minimum of some turns; without a compiler, "bare C++" is missing."""
    taken: dict[str, list[Taken]] = {}
    with tempfile.TemporaryDirectory() as folder, background("sender", "paced", transforms, rate_hz):
        program = compile_bare_reader(folder)
        for _ in range(TURNS):
            for api in ("tfloom", "cyclonedds"):
                taken.setdefault(api, []).append(Taken(*run("listener", api, 1_000_000_000 // rate_hz)))
            if program is not None:
                taken.setdefault("bare C++", []).append(run_bare_reader(program))
    return {api: min(values) for api, values in taken.items()}


if __name__ == "__main__":
    print(json.dumps({"tfloom": tfloom, "cyclonedds": cyclonedds}[sys.argv[1]]()))
