"""How long a command takes to start, as a shell sees it, beside a Python that does nothing.

Each command runs in turn, round by round, so that a busy moment of the machine hits all of them; the table gives the
median and the fastest of each in milliseconds, and the ratio of the medians to `python -c pass`.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

BIN = Path(sys.executable).parent
COMMANDS = {
    "python -c pass": [sys.executable, "-c", "pass"],
    "tfloom --help": [str(BIN / "tfloom"), "--help"],
    "tfloom topic -h": [str(BIN / "tfloom"), "topic", "-h"],
    "tfloom topic echo -h": [str(BIN / "tfloom"), "topic", "echo", "-h"],
    "import rclpy": [sys.executable, "-c", "import rclpy"],
    "import tf2_ros": [sys.executable, "-c", "import tf2_ros"],
    "tfloom topic list": [str(BIN / "tfloom"), "topic", "list"],
}
AIMS_MS = {"tfloom --help": 60, "import rclpy": 100, "tfloom topic list": 500}


def measure(rounds: int) -> dict[str, list[float]]:
    """Return the wall times [ms] of each command."""
    # Bytecode is cached, as it is for a user after the first start.
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    times: dict[str, list[float]] = {name: [] for name in COMMANDS}
    for turn in range(rounds + 1):
        for name, command in COMMANDS.items():
            start = time.perf_counter()
            # No timeout: waiting with one polls, up to 50 ms at a time.
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
            if turn:  # The first round fills caches.
                times[name].append((time.perf_counter() - start) * 1e3)
    return times


def main(argv: list[str] | None = None) -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="starts of each command (default: 15)")
    times = measure(parser.parse_args(argv).rounds)
    baseline = statistics.median(times["python -c pass"])
    print(f"{'start-up':<24}{'median ms':>10}{'best ms':>10}{'ratio':>8}{'aim ms':>8}")
    for name, samples in times.items():
        median = statistics.median(samples)
        aim = AIMS_MS.get(name, "")
        print(f"{name:<24}{median:>10.1f}{min(samples):>10.1f}{median / baseline:>8.1f}{aim:>8}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
