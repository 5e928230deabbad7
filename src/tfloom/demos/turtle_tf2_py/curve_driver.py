"""curve_driver: a turtle draws a Lissajous figure of three waves horizontally and two vertically."""

from __future__ import annotations

import math

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.turtlesim_types import Pose
from tfloom.node.velocities import Velocities, spin_driver

CENTRE_M = 5.544445
RADIUS_M = 4.2
PERIOD_S = 45.0
"""Time for the whole figure [s]."""
LEAD_S = 0.35
"""Time by which the aim is ahead on the figure [s]."""
MAX_SPEED = 4.0
TURN_GAIN = 5.0
"""Turning rate for each radian between heading and aim [1/s]."""


def figure(time_s: float) -> tuple[float, float]:
    """Return the point of the figure at a time [m]."""
    phase = 2 * math.pi * time_s / PERIOD_S
    return CENTRE_M + RADIUS_M * math.sin(3 * phase), CENTRE_M + RADIUS_M * math.sin(2 * phase)


def steer(x: float, y: float, theta: float, aim: tuple[float, float]) -> tuple[float, float]:
    """Return the speed [m/s] and turning rate [rad/s] that move a turtle towards `aim` in LEAD_S."""
    across, up = aim[0] - x, aim[1] - y
    error = math.remainder(math.atan2(up, across) - theta, 2 * math.pi)
    speed = min(math.hypot(across, up) / LEAD_S, MAX_SPEED) * max(0.0, math.cos(error))
    return speed, TURN_GAIN * error


class CurveDriver(Node):
    """Publishes, for each pose of turtle1, the velocity that keeps it on the figure."""

    def __init__(self) -> None:
        super().__init__("curve_driver")
        self.started_ns = self.get_clock().now().nanoseconds
        self.velocities = Velocities(self.create_publisher(Twist, "turtle1/cmd_vel", 7))
        self.create_subscription(Pose, "turtle1/pose", self.on_pose, 1)

    def on_pose(self, pose: Pose) -> None:
        """Steer towards the figure's next point."""
        time_s = (self.get_clock().now().nanoseconds - self.started_ns) / 1e9
        self.velocities.publish(*steer(pose.x, pose.y, pose.theta, figure(time_s + LEAD_S)))


def main(args: list[str] | None = None) -> int:
    """Drive until stopped; return the exit code."""
    return run_program(args, lambda: spin_driver(CurveDriver()))
