"""Kill a node and list the nodes at once, again and again: `python -m benchmarks.node.killed --turns 300`.

Each turn starts a node, kills the one before it with SIGKILL, and runs `node list`, which then takes the place of the
killed one on the domain. The remaining node must be on each list: the exit code is 1 if it is missing from one.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from statistics import median

import rclpy

from benchmarks.domain import DOMAIN_ID


def be_node(name: str) -> None:
    """Join, print a line, and stay until a line on stdin."""
    rclpy.init()
    node = rclpy.create_node(name)
    print("joined", flush=True)
    sys.stdin.readline()
    node.destroy_node()
    rclpy.shutdown()


class Turns:
    """The turns, on one domain."""

    def __init__(self, domain_id: int) -> None:
        self._environment = {**os.environ, "ROS_DOMAIN_ID": str(domain_id)}
        self.missing: list[str] = []
        self.seconds: list[float] = []

    def run(self, count: int) -> None:
        """Run so many turns."""
        before = self._start("first")
        for turn in range(count):
            name = f"node_{turn}"
            try:
                after = self._start(name)
            finally:
                before.kill()
                before.communicate()
            before = after
            self._list(name)
        before.kill()
        before.communicate()

    def _start(self, name: str) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", "benchmarks.node.killed", "--name", name]
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        process = subprocess.Popen(command, text=True, env=self._environment, **pipes)
        assert process.stdout is not None
        if process.stdout.readline() != "joined\n":
            process.kill()
            raise RuntimeError(f"{name} did not join")
        return process

    def _list(self, name: str) -> None:
        start = time.monotonic()
        done = subprocess.run(
            [sys.executable, "-m", "tfloom", "node", "list"],
            capture_output=True,
            text=True,
            env=self._environment,
            check=False,
        )
        self.seconds.append(time.monotonic() - start)
        if done.returncode != 0 or f"/{name}" not in done.stdout.split():
            self.missing.append(f"{name} is not in {done.stdout!r} {done.stderr!r}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.killed", description=__doc__)
    parser.add_argument("--turns", type=int, default=100)
    parser.add_argument("--domain", type=int, default=DOMAIN_ID, help=argparse.SUPPRESS)
    parser.add_argument("--name", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.name is not None:
        be_node(arguments.name)
        return 0
    turns = Turns(arguments.domain)
    turns.run(arguments.turns)
    print("\n".join(turns.missing[:10]), end="\n" if turns.missing else "")
    print(
        f"{len(turns.missing)} of {arguments.turns} lists lacked the node; a list took {median(turns.seconds):.2f} s "
        f"(median), {max(turns.seconds):.2f} s at most"
    )
    return 1 if turns.missing else 0


if __name__ == "__main__":
    sys.exit(main())
