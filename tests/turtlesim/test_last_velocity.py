"""What programs that drive a robot publish last: zero, however they end; by the table of docs/reliability.md."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from tests.spun import SpunNode, spun

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Pose

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="sends signals to processes")
PAGE = Path(__file__).parents[2] / "docs" / "reliability.md"
TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
BROADCASTER = ("tfloom", "run", "turtle_tf2_py", "turtle_tf2_broadcaster", "--ros-args", "-p")
Start = Callable[..., Any]


class Case(NamedTuple):
    """A program, what it needs, and the topic of its velocities."""

    command: tuple[str, ...]
    others: tuple[tuple[str, ...], ...] = ()
    topic: str = "/turtle1/cmd_vel"


CASES = {
    "draw_square": Case(("tfloom", "run", "turtlesim", "draw_square"), (TURTLESIM,)),
    "mimic": Case(
        (
            "tfloom",
            "run",
            "turtlesim",
            "mimic",
            "--ros-args",
            "-r",
            "input/pose:=/seen",
            "-r",
            "output/cmd_vel:=/turtle1/cmd_vel",
        )
    ),
    "turtle_tf2_listener": Case(
        ("tfloom", "run", "turtle_tf2_py", "turtle_tf2_listener"),
        (TURTLESIM, (*BROADCASTER, "turtlename:=turtle1"), (*BROADCASTER, "turtlename:=turtle2")),
        "/turtle2/cmd_vel",
    ),
    "curve_driver": Case(
        (sys.executable, "-m", "tfloom.demos.child", "tfloom.demos.turtle_tf2_py.curve_driver:main"),
        (TURTLESIM,),
    ),
}
COLUMNS = {"SIGINT": 1, "SIGTERM": 1, "SIGHUP": 2, "SIGKILL": 4}


def table() -> dict[str, list[str]]:
    """Return the cells of each program's row."""
    lines = PAGE.read_text("utf-8").partition("## The last velocity")[2].partition("\n## ")[0].splitlines()
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("| ")]
    return {name: row for row in rows[1:] for name in row[0].split(", ")}


class Listener(SpunNode):
    """What a robot hears."""

    def __init__(self, domain_id: int, topic: str) -> None:
        super().__init__("listener", domain_id)
        self.twists = self.received(Twist, topic)
        self.seen = self.node.create_publisher(Pose, "/seen", 1)

    @property
    def is_moved(self) -> bool:
        self.seen.publish(Pose(linear_velocity=1.0))
        return bool(self.twists) and self.twists[-1] != Twist()

    @property
    def is_stopped(self) -> bool:
        return bool(self.twists) and self.twists[-1] == Twist()


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM", "SIGHUP", "SIGKILL"])
def test_last_velocity_of_a_program_that_ends_by_a_signal(
    domain_id: int, start_program: Start, name: str, number: str
) -> None:
    case = CASES[name]
    with spun(Listener(domain_id, case.topic)) as listener:
        for other in case.others:
            start_program(*other)
        program = start_program(*case.command, **({"stdin": -1} if "child" in str(case.command) else {}))
        listener.spin_until(lambda: listener.is_moved)
        program.signal(getattr(signal, number))
        expect_last(listener, program, table()[name][COLUMNS[number]])
        assert "Traceback" not in program.output


def expect_last(listener: Listener, program: Any, cell: str) -> None:
    """Wait for the end of a program, and check what the table says of it."""
    code = program.wait()
    if cell.startswith("0"):
        listener.spin_until(lambda: listener.is_stopped)
        assert code >= 0
    else:
        assert cell == "nothing"
        assert not listener.is_stopped


@pytest.fixture
def listener(domain_id: int) -> Iterator[Listener]:
    with spun(Listener(domain_id, "/turtle1/cmd_vel")) as listener:
        yield listener


@pytest.mark.parametrize("end", ["SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGKILL", "q", "eof"])
def test_last_velocity_of_the_keys(
    listener: Listener,
    start_teleop: Start,
    press: Callable[[bytes], int],
    terminal: tuple[int, int],
    end: str,
) -> None:
    teleop = start_teleop()
    listener.spin_until(lambda: press(b"\x1b[A") and listener.is_moved)
    if end == "q":
        press(b"q")
    elif end == "eof":
        with Path(os.devnull).open("rb") as nothing:
            os.dup2(nothing.fileno(), terminal[0])  # the terminal is closed
    else:
        teleop.signal(getattr(signal, end))
    column = COLUMNS.get(end, 3)
    expect_last(listener, teleop, table()["turtle_teleop_key"][column])


def test_keys_that_have_stopped_the_turtle_or_moved_nothing_publish_nothing_at_their_end(
    listener: Listener, start_teleop: Start, press: Callable[[bytes], int]
) -> None:
    teleop = start_teleop("--ros-args", "-p", "scale_linear:=0.0")
    listener.spin_until(lambda: press(b"\x1b[A") and listener.is_stopped)
    count = len(listener.twists)
    press(b"q")
    assert teleop.wait() == 0
    listener.spin_until(lambda: listener.node.count_publishers("/turtle1/cmd_vel") == 0)
    assert set(map(str, listener.twists[count:])) <= {str(Twist())}
