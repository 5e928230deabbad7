"""Measure a robot's kinematics: robot_state_publisher's share of a core, and forward kinematics on arrays.

The peers: the same program from message objects to message objects, and pytransform3d. CPU times are of whole
processes, with the wire's threads, because other load on the machine only adds wall time.
"""

from __future__ import annotations

import contextlib
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from time import perf_counter, process_time

import numpy as np
import psutil

from benchmarks.domain import DOMAIN_ID
from benchmarks.robot.arms import JOINTS, arm
from tfloom.robot.model import RobotModel

RATE_HZ = 1000
SECONDS = 5.0
TURNS = 5
ROOT = Path(__file__).parents[2]


@contextlib.contextmanager
def started(*words: str) -> Iterator[subprocess.Popen[str]]:
    environment = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    process = subprocess.Popen(
        [sys.executable, "-m", *words], env=environment, cwd=ROOT, stdout=subprocess.PIPE, text=True
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def share_of_a_core(*publisher: str) -> float:
    """Return the CPU time that a program takes for a second of states, by that for each message that it answered.

    Joint states are best effort: on a busy machine some are lost.

    Raises:
        RuntimeError: many are.
    """
    with (
        started(*publisher) as program,
        started("benchmarks.robot.states", str(RATE_HZ), str(SECONDS)) as sender,
    ):
        assert sender.stdout is not None
        sender.stdout.readline()
        before = sum(psutil.Process(program.pid).cpu_times()[:2])
        result = json.loads(sender.stdout.readline())
        used_s = sum(psutil.Process(program.pid).cpu_times()[:2]) - before
    if result["received"] < 0.5 * result["sent"]:
        raise RuntimeError(f"{result['received']} messages came back of {result['sent']}")
    return float(used_s / result["received"] * RATE_HZ)


def best_s(call: Callable[[], object]) -> float:
    times = []
    for _ in range(TURNS):
        start = process_time()
        call()
        times.append(process_time() - start)
    return min(times)


def measure_publisher() -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "arm.urdf")
        path.write_text(arm())
        program = ("tfloom", "run", "robot_state_publisher", "robot_state_publisher", str(path))
        ours = share_of_a_core(*program, "--ros-args", "-p", "ignore_timestamp:=true")
        peer = share_of_a_core("benchmarks.robot.by_messages", str(path))
    what = f"robot_state_publisher, {RATE_HZ} Hz of {JOINTS} joints"
    print(f"{what:58} {100 * ours:9.1f} % of a core   message objects {100 * peer:8.1f} {peer / ours:8.1f} x")


def measure_start() -> None:
    """Print the time to read a description."""
    text = arm()
    start = perf_counter()
    RobotModel.from_urdf(text)
    print(f"{'a URDF of 50 joints, read':58} {1e3 * (perf_counter() - start):9.2f} ms")


def measure_forward() -> None:
    model = RobotModel.from_urdf(arm())
    positions = np.random.default_rng(1).uniform(-3, 3, (10_000, JOINTS))
    ours = best_s(lambda: model.forward(positions)) / len(positions)
    one = best_s(lambda: [model.forward(positions[0]) for _ in range(1000)]) / 1000
    print(f"{'forward kinematics of 50 joints, of 10,000 rows, each':58} {1e6 * ours:9.2f} us", end="")
    if importlib.util.find_spec("pytransform3d") is None:
        print("   pytransform3d is not installed")
    else:
        peer = peer_s(positions[0])
        print(f"             pytransform3d   {1e6 * peer:8.1f} {peer / ours:8.0f} x")
    print(f"{'forward kinematics of 50 joints, of one row':58} {1e6 * one:9.2f} us")


def peer_s(positions: np.ndarray) -> float:
    """Return pytransform3d's time for the poses of all links at one row [s]."""
    from pytransform3d.urdf import UrdfTransformManager

    manager = UrdfTransformManager()
    manager.load_urdf(arm())

    def links() -> None:
        for i, position in enumerate(positions.tolist()):
            manager.set_joint(f"joint_{i}", position)
        for i in range(JOINTS + 1):
            manager.get_transform(f"link_{i}", "link_0")

    return best_s(links)


if __name__ == "__main__":
    measure_start()
    measure_forward()
    measure_publisher()
