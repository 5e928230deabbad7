"""multisim: two turtlesims, in the namespaces turtlesim1 and turtlesim2.

Each is a separate program with its own window; one may be closed before the other.
"""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
import time
from collections.abc import Sequence

from tfloom.node.context.utilities import remove_ros_args

NAMESPACES = ("turtlesim1", "turtlesim2")
GRACE_S = 5.0
"""The longest wait for them to end before they are killed [s]."""

Process = subprocess.Popen[bytes]


class Stopped(Exception):  # noqa: N818  # not an error
    """The program has received a signal to end."""


def command_line(namespace: str, args: Sequence[str]) -> list[str]:
    """Return the command for one turtlesim: with `args`, but in `namespace`."""
    program = [sys.executable, "-m", "tfloom.demos.child", "tfloom.turtlesim.node:main"]
    return [*program, "--ros-args", "-r", f"__ns:=/{namespace}", "--", *args]


def run(args: Sequence[str]) -> int:
    """Run both until they have ended, or until Stopped is raised; return the first exit code that isn't 0, or 0."""
    processes: list[Process] = []
    try:
        for namespace in NAMESPACES:
            process = subprocess.Popen(command_line(namespace, args), stdin=subprocess.PIPE)
            # One after the other, so that the first is ended if the second can't start.
            processes.append(process)
        for process in processes:
            process.wait()
    except Stopped:
        pass
    finally:
        codes = end(processes)
    return next((code for code in codes if code), 0)


def end(processes: Sequence[Process]) -> list[int]:
    """Interrupt the running ones, kill them if they don't end in time, and return all exit codes."""
    for process in processes:
        if process.stdin is not None:
            process.stdin.close()
    until = time.monotonic() + GRACE_S
    return [_wait(process, until) for process in processes]


def _wait(process: Process, until: float) -> int:
    try:
        return process.wait(max(0.0, until - time.monotonic()))
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait()


def _stop(*_: object) -> None:
    for number in (
        signal.SIGINT,
        signal.SIGTERM,
    ):  # because a second one would interrupt the clean-up after the first
        signal.signal(number, signal.SIG_IGN)
    raise Stopped


def main(args: list[str] | None = None) -> int:
    """Run both until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog="multisim",
        description="Run two turtlesims, in the namespaces turtlesim1 and turtlesim2. Both receive the ROS arguments.",
    )
    parser.add_argument("--headless", action="store_true", help="open no windows")
    parser.parse_args(remove_ros_args(args))
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _stop)
    return run(args)
