"""Measure what a launch takes: its arguments printed, a process started, and a train of 14 nodes up and following.

The reference's launch has no wheels, so the peers are Python alone: `python -c pass` for the commands, and for
processes the same ones by `subprocess`. The train is that of `examples/workspace`, built by colcon for the run; it
follows when each of the ten wagons has received a speed, which needs its node, the frames of both turtles, and the gap.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from benchmarks.domain import DOMAIN_ID

ROOT = Path(__file__).parents[2]
TFLOOM = str(Path(sys.executable).parent / "tfloom")
WAGONS = 10
MAX_DURATION_S = 60.0
PROCESSES = 10

# Bytecode is cached, as for a user after the first start.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
ENVIRONMENT["ROS_DOMAIN_ID"] = str(DOMAIN_ID)

MANY = f"""
from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=["true"]) for _ in range({PROCESSES})])
"""


def build(folder: Path) -> dict[str, str]:
    """Build the example workspace, and return the environment variables of a shell that has sourced it."""
    shutil.copytree(ROOT / "examples" / "workspace" / "src", folder / "src")
    path = f"{Path(sys.executable).parent}{os.pathsep}{ENVIRONMENT['PATH']}"
    environment = {
        **ENVIRONMENT,
        "PATH": path,
        "COLCON_PYTHON_EXECUTABLE": str(Path(sys.executable).resolve()),
    }
    subprocess.run(["colcon", "build"], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
    script = f". {folder}/install/setup.bash && env -0"
    printed = subprocess.run(
        ["bash", "-c", script], env=environment, check=True, stdout=subprocess.PIPE, text=True
    )
    return dict(line.split("=", 1) for line in printed.stdout.split("\0") if line)


def wall_ms(command: list[str], environment: dict[str, str]) -> float:
    start = time.perf_counter()
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    return (time.perf_counter() - start) * 1e3


def start_all() -> float:
    """Return the time in which the processes run that the launch file starts, without a launch [ms]."""
    start = time.perf_counter()
    for process in [subprocess.Popen(["true"]) for _ in range(PROCESSES)]:
        process.wait()
    return (time.perf_counter() - start) * 1e3


def train_s(environment: dict[str, str]) -> tuple[float, float]:
    """Return the times from the start of the launch until each wagon follows, and from Ctrl-C to its end [s]."""
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor

    moving: set[int] = set()
    all_move = threading.Event()

    def on_speed(wagon: int, twist: Twist) -> None:
        if twist.linear.x != 0.0:
            moving.add(wagon)
            if len(moving) == WAGONS:
                all_move.set()

    with rclpy.init(domain_id=DOMAIN_ID):
        node = rclpy.create_node("stopwatch")
        for wagon in range(1, WAGONS + 1):
            node.create_subscription(
                Twist, f"/wagon{wagon}/cmd_vel", lambda twist, wagon=wagon: on_speed(wagon, twist), 10
            )
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        thread = threading.Thread(target=executor.spin)
        thread.start()
        start = time.perf_counter()
        launcher = subprocess.Popen(
            [TFLOOM, "launch", "train_bringup", "train.launch.py"], env=environment, stdout=subprocess.DEVNULL
        )
        try:
            if not all_move.wait(MAX_DURATION_S):
                raise RuntimeError(f"only the wagons {sorted(moving)} follow after {MAX_DURATION_S:g} s")
            following_s = time.perf_counter() - start
        finally:
            start = time.perf_counter()
            launcher.send_signal(2)
            launcher.wait(MAX_DURATION_S)
            ended_s = time.perf_counter() - start
            executor.shutdown()
            thread.join()
            node.destroy_node()
    return following_s, ended_s


def main(argv: list[str] | None = None) -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=10, help="runs of each command (default: 10)")
    parser.add_argument("--trains", type=int, default=3, help="launches of the train (default: 3)")
    args = parser.parse_args(argv)
    os.environ.update({"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"})
    with tempfile.TemporaryDirectory() as folder:
        environment = build(Path(folder))
        many = Path(folder) / "many.launch.py"
        many.write_text(MANY, "utf-8")
        times: dict[str, list[float]] = {}
        for turn in range(args.rounds + 1):
            rows = {
                "python -c pass": wall_ms([sys.executable, "-c", "pass"], environment),
                "launch --show-args": wall_ms(
                    [TFLOOM, "launch", "train_bringup", "train.launch.py", "--show-args"], environment
                ),
                f"{PROCESSES} processes by subprocess": start_all(),
                f"launch of {PROCESSES} processes": wall_ms([TFLOOM, "launch", str(many)], environment),
            }
            if turn:  # The first round is not counted, because it fills caches.
                for name, value in rows.items():
                    times.setdefault(name, []).append(value)
        baseline = statistics.median(times["python -c pass"])
        print(f"{'command':<28}{'median ms':>10}{'best ms':>10}{'ratio':>8}")
        for name, durations in times.items():
            median = statistics.median(durations)
            print(f"{name:<28}{median:>10.1f}{min(durations):>10.1f}{median / baseline:>8.1f}")
        print(f"\n{'train of 14 nodes':<28}{'follows s':>10}{'ends s':>10}")
        for number in range(1, args.trains + 1):
            following_s, ended_s = train_s(environment)
            print(f"{f'launch {number}':<28}{following_s:>10.2f}{ended_s:>10.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
