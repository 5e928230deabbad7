"""mimic: command one turtle with the velocities of another."""

from __future__ import annotations

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.turtlesim.messages import Pose


class Mimic(Node):
    """Subscribes to input/pose, and publishes the same velocities on output/cmd_vel."""

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
    """Copy velocities until stopped; return the exit code."""
    expect_no_arguments(
        "mimic",
        "Command one turtle with another's velocities: --ros-args -r input/pose:=turtle1/pose "
        "-r output/cmd_vel:=turtle2/cmd_vel.",
        args,
    )
    return run_program(args, lambda: spin(Mimic()))
