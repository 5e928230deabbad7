"""draw_square: drive turtle1 along a square of two metres, repeatedly."""

from __future__ import annotations

import math
from typing import Any

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.turtlesim_types import Pose
from tfloom.node.velocities import Velocities, spin_driver
from tfloom.turtlesim.world import STEP_S, is_usable, normalize_angle

SIDE_M = 2.0
SPEED = 1.0
TURN_SPEED = 0.4
NEAR_M = 0.1
NEAR_RAD = 0.01
STANDING = 0.0001
"""A turtle slower than this has stopped [m/s, rad/s]."""


class Goal:
    """The pose to reach."""

    def __init__(self, x: float, y: float, theta: float) -> None:
        self.x = x
        self.y = y
        self.theta = normalize_angle(theta)

    def is_reached(self, pose: Pose) -> bool:
        """Return whether `pose` is near enough."""
        return (
            abs(pose.x - self.x) < NEAR_M
            and abs(pose.y - self.y) < NEAR_M
            and abs(normalize_angle(pose.theta - self.theta)) < NEAR_RAD
        )


class DrawSquare(Node):
    """Resets turtlesim, then alternately drives ahead and turns left, with a stop after each."""

    def __init__(self) -> None:
        super().__init__("draw_square")
        self._pose: Pose | None = None
        self._goal: Goal | None = None
        self._is_reset = False
        self._skip_pose = False
        self._is_turning = False
        self._is_stopping = False
        self.velocities = Velocities(self.create_publisher(Twist, "turtle1/cmd_vel", 1))
        self.create_subscription(Pose, "turtle1/pose", self._on_pose, 1)
        self._reset = self.create_client(Empty, "reset")
        self._answer: Any = None
        self.create_timer(STEP_S, self._on_timer)

    def _on_pose(self, pose: Pose) -> None:
        if not is_usable(pose.x, pose.y, pose.theta):
            self.get_logger().warning(
                f"Ignoring a pose: not numbers: {pose.x}, {pose.y}, {pose.theta}", throttle_duration_sec=1.0
            )
        elif self._skip_pose:  # it may be from before the reset
            self._skip_pose = False
        else:
            self._pose = pose

    def _on_timer(self) -> None:
        if self._answer is None:
            if self._reset.service_is_ready():
                self._answer = self._reset.call_async(Empty.Request())
        elif self._answer.done() and not self._is_reset:
            self._is_reset = self._skip_pose = True
            self._pose = None
        elif self._pose is not None and self._is_reset:
            self._drive(self._pose)

    def _drive(self, pose: Pose) -> None:
        if self._goal is None:
            self._set_goal(pose)
        elif self._is_stopping:
            self.velocities.publish(0.0, 0.0)
            if abs(pose.linear_velocity) < STANDING and abs(pose.angular_velocity) < STANDING:
                self.get_logger().info("Reached goal")
                self._is_turning = not self._is_turning
                self._set_goal(pose)
        elif self._goal.is_reached(pose):
            self._is_stopping = True
        elif self._is_turning:
            self.velocities.publish(0.0, TURN_SPEED)
        else:
            self.velocities.publish(SPEED, 0.0)

    def _set_goal(self, pose: Pose) -> None:
        """Set the goal: a left turn, or the other end of the side."""
        self._is_stopping = False
        if self._is_turning:
            goal = Goal(pose.x, pose.y, pose.theta + math.pi / 2)
        else:
            ahead = SIDE_M * math.cos(pose.theta), SIDE_M * math.sin(pose.theta)
            goal = Goal(pose.x + ahead[0], pose.y + ahead[1], pose.theta)
        self._goal = goal
        self.get_logger().info(f"New goal [{goal.x:f} {goal.y:f}, {goal.theta:f}]")


def main(args: list[str] | None = None) -> int:
    """Draw until stopped; return the exit code."""
    expect_no_arguments(
        "draw_square", "Reset turtlesim, then drive turtle1 along a square, repeatedly.", args
    )
    return run_program(args, lambda: spin_driver(DrawSquare()))
