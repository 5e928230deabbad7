"""mimic: let one turtle do what another does."""

from __future__ import annotations

import argparse
import sys

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node import spin
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.utilities import remove_ros_args
from tfloom.turtlesim.messages import Pose


class Mimic(Node):
    """Hears input/pose, and commands the same velocities on output/cmd_vel."""

    def __init__(self) -> None:
        super().__init__("turtle_mimic")
        self._publisher = self.create_publisher(Twist, "output/cmd_vel", 1)
        self.create_subscription(Pose, "input/pose", self._on_pose, 1)

    def _on_pose(self, pose: Pose) -> None:
        twist = Twist()
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        self._publisher.publish(twist)


def main(args: list[str] | None = None) -> int:
    """Mimic until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog="mimic",
        description="Let one turtle do what another does: --ros-args -r input/pose:=turtle1/pose "
        "-r output/cmd_vel:=turtle2/cmd_vel.",
    )
    parser.parse_args(remove_ros_args(args))
    return run_program(args, lambda: spin(Mimic()))
