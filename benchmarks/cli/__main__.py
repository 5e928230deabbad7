"""Measure how long commands take from start to end, beside a Python that does nothing.

A turtlesim runs meanwhile on the same domain; commands that use it must have discovered it. The commands run in turn,
round by round, so that other load on the machine affects all of them. The table has the median and the fastest time of
each in milliseconds, its CPU time, and the ratio of the medians to `python -c pass`.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from benchmarks.domain import DOMAIN_ID

TFLOOM = str(Path(sys.executable).parent / "tfloom")
COMMANDS = {
    "python -c pass": [sys.executable, "-c", "pass"],
    "tfloom --help": [TFLOOM, "--help"],
    "tfloom topic -h": [TFLOOM, "topic", "-h"],
    "tfloom topic echo -h": [TFLOOM, "topic", "echo", "-h"],
    "import rclpy": [sys.executable, "-c", "import rclpy"],
    "import tf2_ros": [sys.executable, "-c", "import tf2_ros"],
    "tfloom topic list": [TFLOOM, "topic", "list"],
    "tfloom topic echo --once": [TFLOOM, "topic", "echo", "--once", "/turtle1/pose"],
}
AIMS_MS = {"tfloom --help": 60, "import rclpy": 100, "tfloom topic list": 500}
EXPECTED = {"tfloom topic list": "/turtle1/pose\n", "tfloom topic echo --once": "theta:"}
"""Text in the output of the commands that use the turtlesim."""

# Bytecode is cached, as for a user after the first start.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
ENVIRONMENT["ROS_DOMAIN_ID"] = str(DOMAIN_ID)


class Run(NamedTuple):
    wall_ms: float
    cpu_ms: float


@contextlib.contextmanager
def turtlesim() -> Iterator[None]:
    """Run a turtlesim without a window for the block, which begins after it has started."""
    command = [sys.executable, "-m", "tfloom", "run", "turtlesim", "turtlesim_node", "--headless"]
    # It logs to stderr.
    with subprocess.Popen(command, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stderr is not None
            for line in process.stderr:
                if "Spawning turtle" in line:
                    break
            else:
                raise RuntimeError("turtlesim has not come up")
            yield
        finally:
            process.terminate()


def cpu_s() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(rounds: int) -> dict[str, list[Run]]:
    """Return the times of each command.

    Raises:
        RuntimeError: a command did not find the turtlesim.
    """
    runs: dict[str, list[Run]] = {name: [] for name in COMMANDS}
    for turn in range(rounds + 1):
        for name, command in COMMANDS.items():
            start, cpu_start = time.perf_counter(), cpu_s()
            # No timeout, because a wait with one polls, up to 50 ms at a time.
            done = subprocess.run(command, check=True, stdout=subprocess.PIPE, env=ENVIRONMENT, text=True)
            if turn:  # The first round is not counted, because it fills caches.
                runs[name].append(Run((time.perf_counter() - start) * 1e3, (cpu_s() - cpu_start) * 1e3))
            if EXPECTED.get(name, "") not in done.stdout:
                raise RuntimeError(f"{name} printed no {EXPECTED[name]!r}: {done.stdout!r}")
    return runs


def main(argv: list[str] | None = None) -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="starts of each command (default: 15)")
    rounds = parser.parse_args(argv).rounds
    with turtlesim():
        runs = measure(rounds)
    baseline = statistics.median(run.wall_ms for run in runs["python -c pass"])
    print(f"{'start-up':<26}{'median ms':>10}{'best ms':>10}{'CPU ms':>8}{'ratio':>8}{'aim ms':>8}")
    for name, timed_runs in runs.items():
        walls = [run.wall_ms for run in timed_runs]
        median, cpu = statistics.median(walls), min(run.cpu_ms for run in timed_runs)
        aim = AIMS_MS.get(name, "")
        print(f"{name:<26}{median:>10.1f}{min(walls):>10.1f}{cpu:>8.1f}{median / baseline:>8.1f}{aim:>8}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
