"""turtle_teleop_key: drive a turtle with the keyboard."""

from __future__ import annotations

import argparse
import sys
import threading
from contextlib import suppress
from typing import Any

from tfloom.common.keyboard import Keyboard, NoTerminalError, without_repetitions
from tfloom.common.terminal import report
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.action.client import ActionClient
from tfloom.node.client_library import ok, spin
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.turtlesim_types import RotateAbsolute
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.velocities import Velocities

BANNER = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit."""
NO_TERMINAL = (
    "turtle_teleop_key reads single keys, and its input is not a terminal: run it in a separate terminal"
)
DIRECTIONS = {"up": (1.0, 0.0), "down": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}
"""The command of each arrow key: parts of the linear and of the angular scale."""
HEADINGS = {
    "g": 0.0,
    "t": 0.7854,
    "r": 1.5708,
    "e": 2.3562,
    "d": 3.1416,
    "c": -2.3562,
    "v": -1.5708,
    "b": -0.7854,
}
"""The heading of each key [rad], which is the key's direction from G on the keyboard."""
CANCEL = "f"
QUIT = "q"
POLL_S = 0.1
"""The longest wait for keys between two checks for shutdown."""


class TeleopTurtle(Node):
    """Publishes a velocity command for each arrow key, and sends a goal for each heading key.

    Parameters: scale_linear [m/s], scale_angular [rad/s].
    """

    def __init__(self) -> None:
        super().__init__("teleop_turtle")
        self.declare_parameter("scale_linear", 2.0)
        self.declare_parameter("scale_angular", 2.0)
        self.velocities = Velocities(self.create_publisher(Twist, "turtle1/cmd_vel", 1))
        self._rotator = ActionClient(self, RotateAbsolute, "turtle1/rotate_absolute")
        self._sent: Any = None

    def press(self, key: str) -> bool:
        """Execute a key's command; return False for Q."""
        if key in DIRECTIONS:
            self._drive(*DIRECTIONS[key])
        elif key.lower() in HEADINGS:
            self._turn(HEADINGS[key.lower()])
        elif key.lower() == CANCEL:
            self._cancel()
        return key.lower() != QUIT

    def _drive(self, linear: float, angular: float) -> None:
        self.velocities.publish(
            linear * float(self.get_parameter("scale_linear").value),
            angular * float(self.get_parameter("scale_angular").value),
        )

    def _turn(self, theta: float) -> None:
        if self._rotator.server_is_ready():
            self._sent = self._rotator.send_goal_async(RotateAbsolute.Goal(theta=theta))
        else:
            name = self.resolve_service_name("turtle1/rotate_absolute")
            self.get_logger().warning(
                f"not turned: no server of the action {name} is there. Start turtlesim_node, or remap the action to "
                "the turtle that is there"
            )

    def _cancel(self) -> None:
        """Cancel the last goal, after its acceptance is known."""
        sent, self._sent = self._sent, None
        if sent is not None:
            sent.add_done_callback(
                lambda done: done.result().cancel_goal_async() if done.result().accepted else None
            )

    def run(self, keyboard: Keyboard) -> None:
        """Execute keys until Q, shutdown, or the terminal's end."""
        print(BANNER, flush=True)
        while ok():
            try:
                keys = keyboard.read(POLL_S)
            except EOFError:
                return
            if not all(self.press(key) for key in without_repetitions(keys)):
                return


def spin_quietly(node: Node) -> None:
    """Spin a node until its context is shut down, which is not an error here."""
    with suppress(ExternalShutdownException):
        spin(node)


def main(args: list[str] | None = None) -> int:
    """Drive until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog="turtle_teleop_key",
        description="Drive a turtle: arrow keys publish geometry_msgs/msg/Twist on turtle1/cmd_vel, the keys "
        "around G send goals to turtle1/rotate_absolute. Another turtle: --ros-args -r turtle1/cmd_vel:=NAME/cmd_vel "
        "-r turtle1/rotate_absolute:=NAME/rotate_absolute. Speeds: -p scale_linear:=2.0 [m/s] and "
        "-p scale_angular:=2.0 [rad/s].",
    )
    parser.parse_args(remove_ros_args(args))

    def drive() -> None:
        with Keyboard() as keyboard:
            node = TeleopTurtle()
            # Keys are read on this thread; goal responses and parameters are handled on another.
            threading.Thread(target=spin_quietly, args=(node,), daemon=True).start()
            with node.velocities:
                node.run(keyboard)

    try:
        return run_program(args, drive)
    except NoTerminalError:
        report(NO_TERMINAL)
        return 1
