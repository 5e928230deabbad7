"""The tutorial with tfloom's programs: keys, turtlesim, broadcaster, tf2_echo, each a process, over DDS."""

from __future__ import annotations

import os
import pty
import re
import signal
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

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


def matrix(block: re.Match[str]) -> list[list[float]]:
    """Return the first three rows of a printed matrix."""
    return [[float(cell) for cell in row.split()] for row in block["matrix"].splitlines()]


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
) -> None:
    ours, theirs = terminal
    teleop = start_program("tfloom", "run", "turtlesim", "turtle_teleop_key", stdin=theirs)
    teleop.wait_for("'Q' to quit.")
    start("turtlesim")
    start("broadcaster")
    echo = Echo(start("echo"))
    wait_until(lambda: echo.number("x") == 5.544)

    def until(key: bytes, is_there: Callable[[list[list[float]]], bool]) -> list[list[float]]:
        """Press a key until the frame is where it shall be, and return the first rows of its matrix."""

        def rows() -> list[list[float]]:
            last = echo.last()
            assert last is not None
            assert [row[3] for row in matrix(last)] == [float(last["x"]), float(last["y"]), 0.0]
            return matrix(last)

        wait_until(lambda: os.write(ours, key) and is_there(rows()))
        return rows()

    moved = until(b"\x1b[A", lambda rows: rows[0][3] > 6.0)
    assert [row[:3] for row in moved] == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    until(b"\x1b[D", lambda rows: rows[1][0] > 0.1)
    os.write(ours, b"q")
    assert teleop.wait() == 0


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
