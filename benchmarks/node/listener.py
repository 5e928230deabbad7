"""Measure the share of a core of a TransformListener without lookups, beside a reader in C++.

The reader, `bare_reader.cpp`, drops all samples, so it is the lower limit for a listener on this library. On
cyclonedds' side, a loop reads the messages, and stores nothing; on rclpy's, a callback does, because there are no
wheels of its TransformListener. Both are lower limits of a listener in Python.

Each message carries a number. Those that readers count are compared with those that were sent meanwhile; of tfloom's
listener, the buffer is looked up at the stamp of each message.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import APIS, PEER, background, cyclone_reader, run, wait_for
from benchmarks.node.sender import number_at, stamp_ns, x_of

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


def tfloom(transforms: int, rate_hz: int) -> Taken:
    import rclpy
    from tf2_ros import Buffer, TransformListener

    rclpy.init()
    node = rclpy.create_node("listener")
    buffer = Buffer()
    TransformListener(buffer, node)
    latest = rclpy.time.Time()
    wait_for(lambda: buffer.can_transform("base", "joint_0", latest))

    def spin(seconds: float) -> None:
        rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=seconds)

    def newest() -> int:
        stamp = buffer.lookup_transform("base", "joint_0", latest).header.stamp
        return number_at(stamp.sec * 1_000_000_000 + stamp.nanosec, rate_hz)

    spin(WARM_UP_S)
    first, begin, cpu_begin = newest(), time.monotonic(), time.process_time()
    spin(MEASURED_S)
    cpu, elapsed, last = time.process_time() - cpu_begin, time.monotonic() - begin, newest()
    for number in range(first, last + 1):
        time_ = rclpy.time.Time(nanoseconds=stamp_ns(number, rate_hz))
        for joint in {0, transforms - 1}:
            x = buffer.lookup_transform("base", f"joint_{joint}", time_).transform.translation.x
            if x != x_of(number):
                raise ValueError(f"message {number} is not in the buffer: x is {x}")
    return Taken(cpu / elapsed * 100, (last - first) / elapsed)


class Counted:
    """Counts the messages that a reader drops, and keeps the newest."""

    def __init__(self, transforms: int, rate_hz: int) -> None:
        self._transforms, self._rate_hz = transforms, rate_hz
        self.count = 0
        self._newest: Any = None

    def __call__(self, message: Any) -> None:
        """Take a message, as a callback."""
        self._newest = message
        self.count += 1

    def number(self) -> int:
        """Return the number of the newest message.

        Raises:
            ValueError: it has other content than was sent.
        """
        stamps = [transform.header.stamp for transform in self._newest.transforms]
        numbers = {number_at(stamp.sec * 1_000_000_000 + stamp.nanosec, self._rate_hz) for stamp in stamps}
        expected = [(f"joint_{joint}", x_of(min(numbers)), -0.25) for joint in range(self._transforms)]
        received = [
            (transform.child_frame_id, transform.transform.translation.x, transform.transform.translation.y)
            for transform in self._newest.transforms
        ]
        if len(numbers) != 1 or received != expected:
            raise ValueError("a message arrived with other content")
        return numbers.pop()


def taken(counted: Counted, spin: Callable[[float], None]) -> Taken:
    """Measure a reader that passes messages to `counted` while it spins for some seconds.

    Raises:
        ValueError: the messages counted are more or fewer than those sent meanwhile.
    """
    spin(WARM_UP_S)
    while not counted.count:
        spin(WARM_UP_S)
    first, count, begin, cpu_begin = counted.number(), counted.count, time.monotonic(), time.process_time()
    spin(MEASURED_S)
    cpu, elapsed = time.process_time() - cpu_begin, time.monotonic() - begin
    heard, sent = counted.count - count, counted.number() - first
    if heard != sent:
        raise ValueError(f"{heard} of {sent} messages arrived")
    return Taken(cpu / elapsed * 100, heard / elapsed)


def peer(transforms: int, rate_hz: int) -> Taken:
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from tf2_msgs.msg import TFMessage

    rclpy.init()
    node = rclpy.create_node("listener")
    counted = Counted(transforms, rate_hz)
    node.create_subscription(TFMessage, "/tf", counted, 100)
    executor = SingleThreadedExecutor()
    executor.add_node(node)

    def spin(seconds: float) -> None:
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0:
            executor.spin_once(timeout_sec=left)

    return taken(counted, spin)


def cyclonedds(transforms: int, rate_hz: int) -> Taken:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node import cyclone_types

    participant = DomainParticipant(DOMAIN_ID)
    _, receive = cyclone_reader(participant, "rt/tf", cyclone_types.TFMessage, depth=100)
    counted = Counted(transforms, rate_hz)

    def spin(seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for message in receive(100):
                counted(message)

    return taken(counted, spin)


def compile_bare_reader(folder: str, optimise: str = "-O2") -> str | None:
    """Return the path of the program; None without a compiler."""
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        return None
    sources = [
        NATIVE / "dds" / f"{name}.cpp"
        for name in (
            "library",
            "participant",
            "qos",
            "endpoint",
            "entity",
            "feeder",
            "version",
            "self_test",
            "loopback",
            "memory_probe",
            "topic_type",
        )
    ]
    program = f"{folder}/bare_reader"
    flags = ["-std=c++20", optimise, f"-I{NATIVE}", "-pthread", "-o", program]
    subprocess.run([compiler, *flags, HERE / "bare_reader.cpp", *sources, "-ldl"], check=True)
    return program


def run_bare_reader(program: str) -> Taken:
    from tfloom.rmw.cyclone.config import configuration
    from tfloom.rmw.cyclone.library import find_library

    arguments = [find_library(), str(DOMAIN_ID), configuration(), str(WARM_UP_S), str(MEASURED_S)]
    printed = subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout
    percent, rate_hz = printed.split()
    return Taken(float(percent), float(rate_hz))


def measure(transforms: int, rate_hz: int, apis: Sequence[str] = APIS) -> dict[str, Taken]:
    """Return the CPU time and rate of each: the minimum of some turns; without a compiler, "bare C++" is missing."""
    turns: dict[str, list[Taken]] = {}
    with tempfile.TemporaryDirectory() as folder, background("sender", "paced", transforms, rate_hz):
        program = compile_bare_reader(folder)
        for _ in range(TURNS):
            for api in apis:
                turns.setdefault(api, []).append(Taken(*run("listener", api, transforms, rate_hz, api=api)))
            if program is not None:
                turns.setdefault("bare C++", []).append(run_bare_reader(program))
    return {api: min(values) for api, values in turns.items()}


if __name__ == "__main__":
    listen_by = {"cyclonedds": cyclonedds, PEER: peer}.get(sys.argv[1], tfloom)
    print(json.dumps(listen_by(int(sys.argv[2]), int(sys.argv[3]))))
