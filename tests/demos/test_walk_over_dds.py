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


@pytest.fixture
def start(domain_id: int, start_program: Callable[..., Any]) -> Iterator[Callable[[str], Any]]:
    """Start one of the programs by name."""
    read, write = os.pipe()
    yield lambda name: start_program(*PROGRAMS[name], stdin=read)
    os.close(read)
    os.close(write)


@pytest.fixture
def press(domain_id: int, start_program: Callable[..., Any]) -> Iterator[Callable[[bytes], int]]:
    """Press a key in the terminal of a teleop."""
    ours, theirs = pty.openpty()
    program = start_program("tfloom", "run", "turtlesim", "turtle_teleop_key", stdin=theirs)
    program.wait_for("'Q' to quit.")
    yield lambda key: os.write(ours, key)
    os.close(ours)
    os.close(theirs)


def test_frame_follows_the_keys(
    start: Callable[[str], Any], wait_until: Callable[..., None], press: Callable[[bytes], int]
) -> None:
    start("turtlesim")
    start("broadcaster")
    echo = Echo(start("echo"))
    wait_until(lambda: echo.number("x") == 5.544)

    def pressed_forward() -> bool:
        press(b"\x1b[A")
        return echo.number("x") > 6.0

    wait_until(pressed_forward)
    last = echo.last()
    assert last is not None
    rows = [[float(cell) for cell in row.split()] for row in last["matrix"].splitlines()]
    assert [row[:3] for row in rows] == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    assert [row[3] for row in rows] == [float(last["x"]), float(last["y"]), 0.0]


@pytest.mark.parametrize(
    # tests/test_tutorial.py kills the others, too
    "victim",
    [name if name == "echo" else pytest.param(name, marks=pytest.mark.slow) for name in PROGRAMS],
)
def test_each_program_can_be_killed_and_restarted(
    start: Callable[[str], Any], wait_until: Callable[..., None], victim: str
) -> None:
    programs = {name: start(name) for name in PROGRAMS}
    echo = Echo(programs["echo"])
    wait_until(lambda: echo.number("stamp") > 0.0)
    programs[victim].signal(signal.SIGKILL)
    assert programs[victim].wait() == -signal.SIGKILL
    killed_s = time.time()
    programs[victim] = start(victim)
    echo = Echo(programs["echo"])
    wait_until(lambda: echo.number("stamp") > killed_s + 0.5, what="newer transforms")
    for name, program in programs.items():
        assert program.process.poll() is None, name
        program.signal(signal.SIGINT)
        assert program.wait() == 0, f"{name}: {program.output[-2000:]}"
        assert "Traceback" not in program.output
