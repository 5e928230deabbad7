"""turtle_teleop_key: each program a process, keys through a pseudo-terminal, messages over DDS."""

from __future__ import annotations

import signal
import termios
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.spun import SpunNode, spun

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Pose

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
Start = Callable[..., Any]
Press = Callable[[bytes], int]


class Listener(SpunNode):
    """Subscribes to the commands and the turtle's pose."""

    def __init__(self, domain_id: int) -> None:
        super().__init__("listener", domain_id)
        self.twists = self.received(Twist, "/turtle1/cmd_vel")
        self.poses = self.received(Pose, "/turtle1/pose")


def twisted(twist: Twist) -> tuple[float, float]:
    return twist.linear.x, twist.angular.z


@pytest.fixture
def listener(domain_id: int) -> Iterator[Listener]:
    with spun(Listener(domain_id)) as listener:
        yield listener


def test_keys_drive_and_turn_the_turtle(
    listener: Listener, start_program: Start, start_teleop: Start, press: Press
) -> None:
    turtlesim = start_program(*TURTLESIM)
    listener.spin_until(lambda: listener.poses)
    teleop = start_teleop()
    # Repeatedly, because the first press may precede discovery.
    listener.spin_until(lambda: press(b"\x1b[A") and listener.twists and listener.poses[-1].x > 5.6)
    assert listener.twists[-1].linear.x == 2.0
    assert listener.twists[-1].angular.z == 0.0
    for key, linear, angular in ((b"\x1b[B", -2.0, 0.0), (b"\x1b[C", 0.0, -2.0), (b"\x1b[D", 0.0, 2.0)):
        press(key)
        expected = linear, angular
        listener.spin_until(lambda: twisted(listener.twists[-1]) == expected)  # noqa: B023
    listener.spin_until(
        lambda: listener.poses[-1].angular_velocity == listener.poses[-1].linear_velocity == 0.0
    )

    def press_and_look() -> bool:
        if not listener.poses[-1].angular_velocity:
            press(b"T")
        return abs(listener.poses[-1].theta - 0.7854) < 0.03

    listener.spin_until(press_and_look)
    turtlesim.wait_for("Rotation goal completed successfully")
    press(b"d")
    listener.spin_until(lambda: listener.poses[-1].theta > 1.0)
    press(b"f")
    turtlesim.wait_for("Rotation goal canceled")
    press(b"q")
    assert teleop.wait() == 0
    assert teleop.lines[:5] == [
        "Reading from keyboard",
        "---------------------------",
        "Use arrow keys to move the turtle.",
        "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.",
        "'Q' to quit.",
    ]


def check_end(teleop: Any, number: int, terminal: tuple[int, int], before: list[Any]) -> None:
    """Check that a signal ends the program, and that the terminal is as it was before."""
    assert termios.tcgetattr(terminal[0]) != before
    teleop.signal(number)
    assert teleop.wait() == 0
    assert termios.tcgetattr(terminal[0]) == before
    assert "Traceback" not in teleop.output


def test_heading_key_without_a_turtle_says_what_is_missing_and_ctrl_c_ends_the_program(
    domain_id: int, start_teleop: Start, press: Press, terminal: tuple[int, int]
) -> None:
    before = termios.tcgetattr(terminal[0])
    teleop = start_teleop()
    press(b"t")
    teleop.wait_for("no server of the action /turtle1/rotate_absolute is there. Start turtlesim_node")
    check_end(teleop, signal.SIGINT, terminal, before)


def test_keys_held_down_do_not_queue_up_and_sigterm_ends_the_program(
    listener: Listener, start_teleop: Start, press: Press, terminal: tuple[int, int]
) -> None:
    before = termios.tcgetattr(terminal[0])
    teleop = start_teleop("--ros-args", "-p", "scale_linear:=0.5", "-p", "scale_angular:=0.25")
    # Repeatedly, because the first press may precede discovery.
    listener.spin_until(lambda: press(b"\x1b[A") and listener.twists)
    assert listener.twists[0].linear.x == 0.5
    teleop.pause()
    press(b"\x1b[D" * 200)
    listener.twists.clear()
    teleop.signal(signal.SIGCONT)
    press(b"\x1b[B")
    listener.spin_until(lambda: any(twist.linear.x < 0.0 for twist in listener.twists))
    turns = [twist for twist in listener.twists if twist.angular.z]
    assert 1 <= len(turns) <= 3
    assert turns[0].angular.z == 0.25
    check_end(teleop, signal.SIGTERM, terminal, before)


def test_input_without_terminal_gives_the_remedy(domain_id: int, start_program: Start) -> None:
    teleop = start_program("tfloom", "run", "turtlesim", "turtle_teleop_key")
    assert teleop.wait() == 1
    assert teleop.lines[0].endswith("run it in a separate terminal")
