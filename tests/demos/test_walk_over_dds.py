"""Keys, turtlesim, a broadcaster, tfloom's or an example's, and tf2_echo: each a process, over DDS."""

from __future__ import annotations

import math
import os
import pty
import re
import signal
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import COLCON_PYTHON

BROADCASTER = "tfloom.demos.turtle_tf2_py.turtle_tf2_broadcaster"
PROGRAMS = {
    "turtlesim": ("tfloom", "run", "turtlesim", "turtlesim_node", "--headless"),
    "broadcaster": ("python", "-m", "tfloom.demos.child", f"{BROADCASTER}:main"),
    "echo": ("tfloom", "run", "tf2_ros", "tf2_echo", "world", "turtle1", "20"),
}
BLOCK = re.compile(
    r"At time (?P<stamp>\d+\.\d{9})\n- Translation: \[(?P<x>-?[\d.]+), (?P<y>-?[\d.]+), 0\.000\]\n"
    r"(?:- Rotation.*\n){3}- Matrix:\n(?P<matrix>(?: .*\n){3})  0\.000  0\.000  0\.000  1\.000"
)


class Echo:
    """Return the last transform that tf2_echo has printed."""

    def __init__(self, program: Any) -> None:
        self.program = program

    def last(self) -> re.Match[str] | None:
        matches = list(BLOCK.finditer("\n".join(list(self.program.lines)[-40:])))
        return matches[-1] if matches else None

    def number(self, part: str) -> float:
        """Return its `stamp` or its `x`; 0 before the first one."""
        last = self.last()
        return float(last[part]) if last else 0.0

    def rows(self) -> list[list[float]]:
        """Return the first three rows of its matrix; none before the first one."""
        last = self.last()
        return [[float(cell) for cell in row.split()] for row in last["matrix"].splitlines()] if last else []


@pytest.fixture
def start(domain_id: int, start_program: Callable[..., Any]) -> Iterator[Callable[[str], Any]]:
    """Start one of the programs by name."""
    read, write = os.pipe()
    yield lambda name: start_program(*PROGRAMS[name], stdin=read)
    os.close(read)
    os.close(write)


@pytest.fixture
def terminal() -> Iterator[tuple[int, int]]:
    """Return the ends of a pseudo-terminal: of its user, and of its program."""
    ours, theirs = pty.openpty()
    yield ours, theirs
    os.close(ours)
    os.close(theirs)


def test_frame_follows_the_keys(
    start: Callable[[str], Any],
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
    terminal: tuple[int, int],
    built_broadcaster: list[str],
) -> None:
    ours, theirs = terminal
    teleop = start_program("tfloom", "run", "turtlesim", "turtle_teleop_key", stdin=theirs)
    teleop.wait_for("'Q' to quit.")
    start("turtlesim")
    broadcaster = start_program(*built_broadcaster, env=os.environ | COLCON_PYTHON)
    broadcaster.wait_for("[broadcaster]: Broadcasting world to turtle1")
    echo = Echo(start("echo"))
    wait_until(lambda: echo.number("x") == 5.544)
    poses = start_program("tfloom", "topic", "echo", "--csv", "/turtle1/pose")

    def press_until(key: bytes, is_there: Callable[[list[list[float]]], bool]) -> None:
        wait_until(lambda: os.write(ours, key) and is_there(echo.rows()))

    press_until(b"\x1b[A", lambda rows: rows[0][3] > 6.0)
    assert [row[:3] for row in echo.rows()] == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    press_until(b"\x1b[D", lambda rows: rows[1][0] > 0.1)
    os.write(ours, b"q")
    assert teleop.wait() == 0
    wait_until(lambda: poses.lines and poses.lines[-1].endswith(",0.0,0.0"), what="the turtle to stand")
    x, y, theta, *_ = (float(value) for value in poses.lines[-1].split(","))
    sine, cosine = math.sin(theta), math.cos(theta)
    standing = [[cosine, -sine, 0.0, x], [sine, cosine, 0.0, y], [0.0, 0.0, 1.0, 0.0]]
    wait_until(lambda: echo.rows() == [pytest.approx(row, abs=0.0006) for row in standing])
    assert echo.number("x") == pytest.approx(x, abs=0.0006)
    broadcaster.signal(signal.SIGINT)
    broadcaster.wait()
    assert "Traceback" not in broadcaster.output


def test_each_program_can_be_killed_and_restarted(
    start: Callable[[str], Any], wait_until: Callable[..., None]
) -> None:
    programs = {name: start(name) for name in PROGRAMS}
    wait_until(lambda: Echo(programs["echo"]).number("stamp") > 0.0)
    for victim in PROGRAMS:
        programs[victim].signal(signal.SIGKILL)
        assert programs[victim].wait() == -signal.SIGKILL
        killed_s = time.time()
        programs[victim] = start(victim)
        echo = Echo(programs["echo"])
        wait_until(lambda: echo.number("stamp") > killed_s + 0.5, what=f"newer transforms after {victim}")  # noqa: B023
    for name, program in programs.items():
        assert program.process.poll() is None, name
        program.signal(signal.SIGINT)
        assert program.wait() == 0, f"{name}: {program.output[-2000:]}"
        assert "Traceback" not in program.output
