"""mimic: command one turtle with the velocities of another."""

from __future__ import annotations

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.turtlesim_types import Pose
from tfloom.node.velocities import Velocities, spin_driver


class Mimic(Node):
    """Subscribes to input/pose, and publishes the same velocities on output/cmd_vel."""

    def __init__(self) -> None:
        super().__init__("turtle_mimic")
        self.velocities = Velocities(self.create_publisher(Twist, "output/cmd_vel", 1))
        self.create_subscription(Pose, "input/pose", self._on_pose, 1)

    def _on_pose(self, pose: Pose) -> None:
        self.velocities.publish(pose.linear_velocity, pose.angular_velocity)


def main(args: list[str] | None = None) -> int:
    """Copy velocities until stopped; return the exit code."""
    expect_no_arguments(
        "mimic",
        "Command one turtle with another's velocities: --ros-args -r input/pose:=turtle1/pose "
        "-r output/cmd_vel:=turtle2/cmd_vel.",
        args,
    )
    return run_program(args, lambda: spin_driver(Mimic()))
