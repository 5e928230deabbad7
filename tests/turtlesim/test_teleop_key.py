"""turtle_teleop_key: each program a process, keys through a pseudo-terminal, messages over DDS."""

from __future__ import annotations

import os
import pty
import signal
import termios
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

TELEOP = ("tfloom", "run", "turtlesim", "turtle_teleop_key")
TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")


class Listener:
    """Subscribes to the commands and the turtle's pose."""

    def __init__(self) -> None:
        init(args=[])
        self.twists: list[Twist] = []
        self.poses: list[Pose] = []
        self._node = Node("listener")
        self._node.create_subscription(Twist, "/turtle1/cmd_vel", self.twists.append, 10)
        self._node.create_subscription(Pose, "/turtle1/pose", self.poses.append, 10)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self._node)

    def spin_until(self, condition: Callable[[], object], wait_until: Callable[..., None]) -> None:
        def spin_and_look() -> object:
            self._executor.spin_once(timeout_sec=0.01)
            return condition()

        wait_until(spin_and_look)

    def end(self) -> None:
        self._executor.shutdown()
        self._node.destroy_node()
        try_shutdown()


def twisted(twist: Twist) -> tuple[float, float]:
    return twist.linear.x, twist.angular.z


@pytest.fixture
def listener(domain_id: int) -> Iterator[Listener]:
    listener = Listener()
    yield listener
    listener.end()


@pytest.fixture
def terminal() -> Iterator[tuple[int, int]]:
    ours, theirs = pty.openpty()
    yield ours, theirs
    os.close(ours)
    os.close(theirs)


def press_until(
    listener: Listener,
    ours: int,
    key: bytes,
    condition: Callable[[], object],
    wait_until: Callable[..., None],
) -> None:
    """Press a key repeatedly, because the first press may precede discovery."""

    def pressed() -> object:
        os.write(ours, key)
        return condition()

    listener.spin_until(pressed, wait_until)


def test_arrow_keys_drive_the_turtle(
    listener: Listener,
    start_program: Callable[..., Any],
    terminal: tuple[int, int],
    wait_until: Callable[..., None],
) -> None:
    ours, theirs = terminal
    start_program(*TURTLESIM)
    listener.spin_until(lambda: listener.poses, wait_until)
    teleop = start_program(*TELEOP, stdin=theirs)
    teleop.wait_for("'Q' to quit.")
    press_until(listener, ours, b"\x1b[A", lambda: listener.poses[-1].x > 5.6, wait_until)
    assert listener.twists[-1].linear.x == 2.0
    assert listener.twists[-1].angular.z == 0.0
    for key, linear, angular in ((b"\x1b[B", -2.0, 0.0), (b"\x1b[C", 0.0, -2.0), (b"\x1b[D", 0.0, 2.0)):
        os.write(ours, key)
        expected = linear, angular
        listener.spin_until(lambda: twisted(listener.twists[-1]) == expected, wait_until)  # noqa: B023
    os.write(ours, b"q")
    assert teleop.wait() == 0
    assert teleop.lines == [
        "Reading from keyboard",
        "---------------------------",
        "Use arrow keys to move the turtle.",
        "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.",
        "'Q' to quit.",
    ]


def test_heading_keys_turn_the_turtle(
    listener: Listener,
    start_program: Callable[..., Any],
    terminal: tuple[int, int],
    wait_until: Callable[..., None],
) -> None:
    ours, theirs = terminal
    turtlesim = start_program(*TURTLESIM)
    listener.spin_until(lambda: listener.poses, wait_until)
    start_program(*TELEOP, stdin=theirs).wait_for("'Q' to quit.")

    def press_and_look() -> bool:
        if not listener.poses[-1].angular_velocity:
            os.write(ours, b"T")
        return listener.poses[-1].theta > 0.7

    listener.spin_until(press_and_look, wait_until)
    turtlesim.wait_for("Rotation goal completed successfully")
    listener.spin_until(lambda: abs(listener.poses[-1].theta - 0.7854) < 0.03, wait_until)
    os.write(ours, b"d")
    listener.spin_until(lambda: listener.poses[-1].theta > 1.0, wait_until)
    os.write(ours, b"f")
    turtlesim.wait_for("Rotation goal canceled")


def test_heading_key_without_a_turtle_says_what_is_missing(
    domain_id: int, start_program: Callable[..., Any], terminal: tuple[int, int]
) -> None:
    ours, theirs = terminal
    teleop = start_program(*TELEOP, stdin=theirs)
    teleop.wait_for("'Q' to quit.")
    os.write(ours, b"t")
    teleop.wait_for("no server of the action /turtle1/rotate_absolute is there. Start turtlesim_node")


def test_keys_held_down_do_not_queue_up(
    listener: Listener,
    start_program: Callable[..., Any],
    terminal: tuple[int, int],
    wait_until: Callable[..., None],
) -> None:
    ours, theirs = terminal
    teleop = start_program(
        *TELEOP, "--ros-args", "-p", "scale_linear:=0.5", "-p", "scale_angular:=0.25", stdin=theirs
    )
    teleop.wait_for("'Q' to quit.")
    press_until(listener, ours, b"\x1b[A", lambda: listener.twists, wait_until)
    assert listener.twists[0].linear.x == 0.5
    teleop.pause()
    os.write(ours, b"\x1b[D" * 200)
    listener.twists.clear()
    teleop.signal(signal.SIGCONT)
    os.write(ours, b"\x1b[B")
    listener.spin_until(lambda: any(twist.linear.x < 0.0 for twist in listener.twists), wait_until)
    turns = [twist for twist in listener.twists if twist.angular.z]
    assert 1 <= len(turns) <= 3
    assert turns[0].angular.z == 0.25


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_ends_the_program_and_restores_the_terminal(
    domain_id: int, start_program: Callable[..., Any], terminal: tuple[int, int], number: int
) -> None:
    ours, theirs = terminal
    before = termios.tcgetattr(ours)
    teleop = start_program(*TELEOP, stdin=theirs)
    teleop.wait_for("'Q' to quit.")
    assert termios.tcgetattr(ours) != before
    teleop.signal(number)
    assert teleop.wait() == 0
    assert termios.tcgetattr(ours) == before
    assert "Traceback" not in teleop.output


def test_input_without_terminal_gives_the_remedy(domain_id: int, start_program: Callable[..., Any]) -> None:
    teleop = start_program(*TELEOP)
    assert teleop.wait() == 1
    assert teleop.lines[0].endswith("run it in a terminal of its own")
