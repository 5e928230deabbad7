"""Measure the CPU of a real rclpy's process that receives /tf: by the drop-in listener, and by its peers, in one run.

The peer is tf2_ros's listener if a ROS 2 is sourced. Otherwise it is a subscription of the rclpy that `make ros-peer`
installs, which only decodes the messages and stores nothing. The aim is a tenth of the peer's CPU.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, NamedTuple

from tools.ros_peer import NoPeerError, RosPeer, find
from tools.staged import stage, stage_dds

from benchmarks.domain import DOMAIN_ID
from tfloom.drop_in import real_ros
from tfloom.rmw.cyclone.config import configuration

ROOT = Path(__file__).parents[2]
CASES = ((1, 1000), (50, 100))
"""Transforms in a message, and messages a second."""
MEASURED_S = 4.0
SETTLING_S = 0.5
TURNS = 3
ON_LOOPBACK = os.environ | {
    "ROS_DOMAIN_ID": str(DOMAIN_ID),
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    "CYCLONEDDS_URI": configuration(),
}
NAMES = {
    "drop_in": "drop-in, own reader",
    "raw": "drop-in, raw subscription",
    "decoding": "rclpy, only decoding",
    "tf2_ros": "tf2_ros's listener",
}


class Taken(NamedTuple):
    percent: float
    """CPU time of the process, with all its threads [% of a core]."""
    transforms: int


class Processes:
    """Starts the two ends: the receivers in a real rclpy's Python."""

    def __init__(self, peer: RosPeer | None, folder: Path) -> None:
        self._peer = peer
        self._folder = folder
        self.peer_way = "tf2_ros" if peer is None else "decoding"

    def receiver(self, way: str, expected: int) -> subprocess.Popen[str]:
        command = ["-m", "benchmarks.drop_in.receiver", way, str(expected)]
        pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "cwd": ROOT}
        if self._peer is None:
            return subprocess.Popen([sys.executable, *command], text=True, env=ON_LOOPBACK, **pipes)
        return self._peer.start(command, DOMAIN_ID, paths=[ROOT, self._folder], **pipes)

    @staticmethod
    def sender(*arguments: int) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-m", "benchmarks.drop_in.sender", *map(str, arguments)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=ON_LOOPBACK,
            cwd=ROOT,
        )


def measure(processes: Processes, way: str, transforms: int, rate_hz: int) -> Taken:
    """Return the CPU of a receiver while messages arrive.

    Raises:
        RuntimeError: it did not receive each transform that was sent.
    """
    count = int(MEASURED_S * rate_hz)
    with ExitStack() as stack:
        receiver = stack.enter_context(processes.receiver(way, count * transforms))
        stack.callback(receiver.kill)
        sender = stack.enter_context(processes.sender(transforms, rate_hz, count))
        stack.callback(sender.kill)
        assert sender.stdout.readline() == "matched\n"
        time.sleep(SETTLING_S)  # until the other end has matched, too
        for program in (receiver, sender):
            tell(program)
        assert sender.stdout.readline().startswith("sent")
        tell(receiver)
        cpu_s, elapsed_s, received = json.loads(receiver.stdout.readline())
    if received != count * transforms:
        raise RuntimeError(f"{way} received {received} transforms of {count * transforms}")
    return Taken(cpu_s / elapsed_s * 100, received)


def tell(process: subprocess.Popen[str]) -> None:
    process.stdin.write("\n")
    process.stdin.flush()


def find_peer() -> RosPeer | None:
    """Return the installed peer; None where a ROS 2 with tf2_ros is sourced.

    Raises:
        NoPeerError: there is neither.
    """
    if real_ros.has_rclpy() and real_ros.find("tf2_ros"):
        return None
    peer = find()
    if not peer.has("tf2_msgs"):
        raise NoPeerError("tf2_msgs could not be compiled for the real rclpy")
    return peer


def main() -> int:
    try:
        peer = find_peer()
    except NoPeerError as error:
        print(f"not measured: {error}")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        processes = Processes(peer, stage_dds(stage(Path(folder))))
        ways = ("drop_in", "raw", processes.peer_way)
        print(
            f"{'CPU of a process that receives /tf [% of a core]':<52}{'CPU':>8}{'ratio':>8}{'received':>12}"
        )
        for transforms, rate_hz in CASES:
            rounds = {way: [] for way in ways}
            for _ in range(TURNS):
                for way in ways:
                    rounds[way].append(measure(processes, way, transforms, rate_hz))
            best = {way: min(values) for way, values in rounds.items()}
            print(f"  {rate_hz} Hz x {transforms} transforms, least of {TURNS} runs")
            for way in ways:
                ratio = best[processes.peer_way].percent / best[way].percent
                print(
                    f"    {NAMES[way]:<48}{best[way].percent:>8.1f}{ratio:>8.1f}{best[way].transforms:>12,}",
                    flush=True,
                )
    return 0


if __name__ == "__main__":
    sys.exit(main())
