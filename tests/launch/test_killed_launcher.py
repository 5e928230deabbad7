"""A launcher that is killed leaves no process behind: neither those that it started, nor their children."""

from __future__ import annotations

import os
import random
import sys
import time
from collections.abc import Callable
from pathlib import Path

import psutil
import pytest
from tests.conftest import TIMEOUT_S

pytestmark = pytest.mark.skipif(os.name == "nt", reason="SIGKILL and a POSIX shell are needed")

AT_ONCE = 5
MAX_DURATION_S = 0.6
"""The longest time from the start of a launcher to its end, in which all its processes have started."""

FILE = """
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    mark = {mark!r}
    def bash(code, **options):
        return ExecuteProcess(cmd=["bash", "-c", code, mark], output="screen", **options)
    return LaunchDescription([
        bash(f"exec -a {{mark}} sleep 600"),
        bash(f"(exec -a {{mark}} sleep 600); true"),
        bash(f"setsid bash -c 'exec -a {{mark}} sleep 600' & echo begun; wait"),
        bash(f"exec env -i bash -c 'sleep 600; true' {{mark}}"),
        ExecuteProcess(cmd=[sys.executable, "-c", "import time\\ntime.sleep(600)", mark], respawn=True),
    ])
"""


def alive(marks: list[str]) -> list[psutil.Process]:
    """Return the processes with one of these words on their command lines; it reads those of the whole machine."""
    return [
        process
        for process in psutil.process_iter(["cmdline", "status"])
        if process.info["status"] != psutil.STATUS_ZOMBIE
        and not set(marks).isdisjoint(process.info["cmdline"] or [])
    ]


def kill_launchers(
    count: int, folder: Path, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> int:
    """Kill that many launchers at random moments, and return how many processes they had then."""
    marks = [f"mark-{os.getpid()}-{random.randrange(10**9)}" for _ in range(count)]
    launchers = []
    for mark in marks:
        file = folder / f"{mark}.launch.py"
        file.write_text(FILE.format(mark=mark), "utf-8")
        launchers.append(start_program(sys.executable, "-m", "tfloom", "launch", file))
    for launcher in launchers:
        launcher.wait_for("process started")
        time.sleep(random.uniform(0.0, MAX_DURATION_S))
    processes = alive(marks)
    for launcher in launchers:
        launcher.process.kill()
    for launcher in launchers:
        launcher.process.wait(30)
    psutil.wait_procs(processes, timeout=TIMEOUT_S)
    # One that was started in the meantime is not among them.
    wait_until(lambda: not alive(marks), what=f"the end of {alive(marks)}")
    return len(processes)


def test_a_killed_launcher_leaves_nothing(
    tmp_path: Path, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    assert kill_launchers(3, tmp_path, start_program, wait_until) >= 3


@pytest.mark.slow
def test_fifty_killed_launchers_leave_nothing(
    tmp_path: Path, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    for _ in range(50 // AT_ONCE):
        assert kill_launchers(AT_ONCE, tmp_path, start_program, wait_until) >= AT_ONCE
