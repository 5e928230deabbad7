"""turtle_teleop_key: drive a turtle with the arrow keys."""

from __future__ import annotations

import argparse
import sys

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node import init, ok
from tfloom.node.executor import ExternalShutdownException
from tfloom.node.node import Node
from tfloom.node.utilities import remove_ros_args, try_shutdown
from tfloom.turtlesim.keyboard import Keyboard, NoTerminalError

BANNER = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
'Q' to quit."""
NO_TERMINAL = (
    "turtle_teleop_key reads single keys and needs a terminal, but its input is none: "
    "run it in a terminal of its own"
)
DIRECTIONS = {"up": (1.0, 0.0), "down": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}
"""What each arrow key commands: parts of the linear and of the angular scale."""
POLL_S = 0.1
"""How long a wait for keys may last before it looks whether the program is to end."""


class TeleopTurtle(Node):
    """Publishes a velocity command for each key press; parameters scale_linear [m/s], scale_angular [rad/s]."""

    def __init__(self) -> None:
        super().__init__("teleop_turtle")
        self.declare_parameter("scale_linear", 2.0)
        self.declare_parameter("scale_angular", 2.0)
        self._publisher = self.create_publisher(Twist, "turtle1/cmd_vel", 1)

    def press(self, key: str) -> bool:
        """Do what a key asks for; return whether to go on."""
        if key in DIRECTIONS:
            linear, angular = DIRECTIONS[key]
            twist = Twist()
            twist.linear.x = linear * float(self.get_parameter("scale_linear").value)
            twist.angular.z = angular * float(self.get_parameter("scale_angular").value)
            self._publisher.publish(twist)
        return key not in {"q", "Q"}

    def run(self, keyboard: Keyboard) -> None:
        """Obey the keyboard until Q, shutdown, or the terminal's end."""
        print(BANNER, flush=True)
        while ok():
            try:
                keys = keyboard.read(POLL_S)
            except EOFError:
                return
            if not all(self.press(key) for key in keys):
                return


def main(args: list[str] | None = None) -> int:
    """Drive until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog="turtle_teleop_key",
        description="Drive a turtle: arrow keys publish geometry_msgs/msg/Twist on turtle1/cmd_vel. "
        "Another turtle: --ros-args -r turtle1/cmd_vel:=NAME/cmd_vel. Speeds: -p scale_linear:=2.0 [m/s] and "
        "-p scale_angular:=2.0 [rad/s].",
    )
    parser.parse_args(remove_ros_args(args))
    init(args=args)
    try:
        with Keyboard() as keyboard:
            TeleopTurtle().run(keyboard)
    except NoTerminalError:
        print(NO_TERMINAL, file=sys.stderr)
        return 1
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        try_shutdown()
    return 0
