"""Measure what tools take of a core that watch 100 frames at 1 kHz over DDS, without their start."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID

FRAMES, RATE_HZ = 100, 1000
SHORT_S, LONG_S = 1.0, 6.0
"""Two lengths of a run; the difference of their CPU times has no start in it."""
TURNS = 3
ENVIRONMENT = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
LISTENER = """
import sys, time, rclpy
from tf2_ros import Buffer, TransformListener
rclpy.init()
node = rclpy.create_node("listener")
TransformListener(Buffer(), node)
rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=float(sys.argv[1]))
"""


class Run(NamedTuple):
    """A run of a program."""

    cpu_s: float
    output: str


@contextmanager
def robot() -> Iterator[None]:
    """Publish the frames for the block."""
    command = [sys.executable, "-m", "benchmarks.tf2_tools.sender", str(FRAMES), str(RATE_HZ)]
    sender = subprocess.Popen(command, stdin=subprocess.PIPE, env=ENVIRONMENT)
    try:
        yield
    finally:
        sender.communicate()


def run(*command: str) -> Run:
    """Run a program to its end."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([sys.executable, *command], stdout=output, env=ENVIRONMENT)
        _, _, usage = os.wait4(process.pid, 0)
        output.seek(0)
        return Run(usage.ru_utime + usage.ru_stime, output.read())


def share(*command: str) -> float:
    """Return the share of a core of a program whose last argument is its duration [s]."""
    long, short = run(*command, str(LONG_S)), run(*command, str(SHORT_S))
    return (long.cpu_s - short.cpu_s) / (LONG_S - SHORT_S)


def main() -> None:
    with robot():
        report = json.loads(run("-m", "tfloom", "tf", "doctor", "--json", "--seconds", "3").output)
        rate_hz = report["transforms"] / report["duration_s"]
        listener = min(share("-c", LISTENER) for _ in range(TURNS))
        doctor = min(share("-m", "tfloom", "tf", "doctor", "--json", "--seconds") for _ in range(TURNS))
    print(f"{rate_hz:,.0f} transforms/s seen, {report['frames']} frames")
    print(f"TransformListener    {listener:6.1%} of a core")
    print(f"tfloom tf doctor     {doctor:6.1%} of a core, {doctor / listener:.2f} times the listener's")


if __name__ == "__main__":
    main()
