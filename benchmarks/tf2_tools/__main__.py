"""Measure what tools take of a core that watch 100 frames at 1 kHz over DDS, without their start."""

from __future__ import annotations

import fcntl
import json
import os
import pty
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.tf2_tools.observer import main as time_of_observer

FRAMES, RATE_HZ = 100, 1000
SHORT_S, LONG_S = 1.0, 6.0
"""Two lengths of a run; the difference of their CPU times has no start in it."""
TURNS = 3
ENVIRONMENT = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
TF = ("-m", "tfloom", "tf")
LISTENER = """
import sys, time, rclpy
from tf2_ros import Buffer, TransformListener
rclpy.init()
node = rclpy.create_node("listener")
TransformListener(Buffer(), node)
rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=float(sys.argv[1]))
"""

OBSERVER = """
import sys, time
from contextlib import closing
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.live import LiveWatch
node = NodeName("/", "_observer")
with closing(open_participant()) as participant:
    participant.add_node(node)
    with closing(LiveWatch(participant, node, buffer=Buffer())) as watch:
        end_s = time.monotonic() + float(sys.argv[1])
        while time.monotonic() < end_s:
            time.sleep(0.1)
            watch.observation()
"""
"""Observes, fills a buffer, and takes ten observations a second."""


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


def run_on_terminal(seconds: float, *command: str) -> Run:
    """Run a program on a terminal of 140 columns and 50 lines, and press q after some seconds of its first output."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 50, 140, 0, 0))
    environment = ENVIRONMENT | {"TERM": "xterm-256color"}
    process = subprocess.Popen(
        [sys.executable, *command], stdin=theirs, stdout=theirs, stderr=theirs, env=environment
    )
    output, end_s = os.read(ours, 65536), time.monotonic() + seconds
    while (left_s := end_s - time.monotonic()) > 0.0:
        if select.select([ours], [], [], left_s)[0]:
            output += os.read(ours, 65536)
    os.write(ours, b"q")
    _, _, usage = os.wait4(process.pid, 0)
    os.close(theirs)
    os.close(ours)
    return Run(usage.ru_utime + usage.ru_stime, output.decode("utf-8", "replace"))


def share(run_for: Callable[[float], Run]) -> float:
    """Return the share of a core of a program that is run for a time [s]."""
    return (run_for(LONG_S).cpu_s - run_for(SHORT_S).cpu_s) / (LONG_S - SHORT_S)


def main() -> None:
    time_of_observer()
    with robot():
        report = json.loads(run(*TF, "doctor", "--json", "--seconds", "3").output)
        rate_hz = report["transforms"] / report["duration_s"]
        listener = min(share(lambda s: run("-c", LISTENER, str(s))) for _ in range(TURNS))
        observer = min(share(lambda s: run("-c", OBSERVER, str(s))) for _ in range(TURNS))
        doctor = min(share(lambda s: run(*TF, "doctor", "--json", "--seconds", str(s))) for _ in range(TURNS))
        top = min(share(lambda s: run_on_terminal(s, *TF, "top")) for _ in range(TURNS))
        screen = run_on_terminal(SHORT_S, *TF, "top").output
    if f"{FRAMES + 1} frames, {FRAMES} edges" not in screen:
        raise RuntimeError(f"tf top does not show the frames: {screen[:300]!r}")
    print(f"{rate_hz:,.0f} transforms/s seen, {report['frames']} frames")
    print(f"TransformListener    {listener:6.1%} of a core")
    print(f"observer and buffer  {observer:6.1%} of a core, {observer / listener:.2f} times the listener's")
    print(f"tfloom tf doctor     {doctor:6.1%} of a core, {doctor / listener:.2f} times the listener's")
    print(f"tfloom tf top        {top:6.1%} of a core, {top / listener:.2f} times the listener's")


if __name__ == "__main__":
    main()
