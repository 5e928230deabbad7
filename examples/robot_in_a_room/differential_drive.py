"""Move a robot with two driven wheels: its true pose, and what its odometry takes for its pose."""

from __future__ import annotations

import math

import numpy as np
from planar import Pose2D
from room import Room

WHEEL_RADIUS_M = 0.1
TRACK_M = 0.36
"""Distance between the wheels."""
BODY_RADIUS_M = 0.25
MAX_SPEED = 0.8, 1.6
"""Of the robot: ahead [m/s], turning [rad/s]."""
MAX_ACCELERATION = 1.5, 4.0
MAX_STEP_S = 0.02


class DifferentialDrive:
    """Integrates the movement of both wheels.

    The odometry counts the turns of the wheels, as encoders do, and takes both for equal. In truth the right wheel is a
    little smaller and the track a little wider, and wheels slip at random, so that the odometry drifts. Against a wall
    the robot stands while its wheels turn on.

    Args:
        room: The walls and pillars that stop the robot.
        wheel_error: Part by which the right wheel is smaller than the left one.
        track_error: Part by which the track is wider than the odometry assumes.
        slip: Standard deviation of each wheel's slip on a metre [m].
        seed: Of the random slip.
    """

    def __init__(
        self,
        room: Room,
        wheel_error: float = 0.004,
        track_error: float = 0.02,
        slip: float = 0.01,
        seed: int = 1,
    ) -> None:
        self.room = room
        self.radii = np.array([WHEEL_RADIUS_M, WHEEL_RADIUS_M * (1.0 - wheel_error)])
        self.track = TRACK_M * (1.0 + track_error)
        self.slip = slip
        self.random = np.random.default_rng(seed)
        self.truth = Pose2D()
        self.odometry = Pose2D()
        self.wheels = np.zeros(2)
        """How far the left and the right wheel have turned [rad]."""
        self.speed = (0.0, 0.0)
        """The present speed by the wheels: ahead [m/s], turning [rad/s]."""
        self.command = (0.0, 0.0)
        self.is_blocked = False

    def drive(self, linear: float, angular: float) -> None:
        """Set the speed to aim at: ahead [m/s], turning [rad/s]; raise ValueError for what isn't finite."""
        if not (math.isfinite(linear) and math.isfinite(angular)):
            raise ValueError(f"a speed has to be finite, not {linear} m/s and {angular} rad/s")
        ahead, turn = MAX_SPEED
        self.command = max(-ahead, min(linear, ahead)), max(-turn, min(angular, turn))

    def step(self, duration_s: float) -> None:
        """Let time pass, in short steps."""
        steps = max(1, math.ceil(duration_s / MAX_STEP_S))
        for _ in range(steps):
            self._short_step(duration_s / steps)

    def _short_step(self, duration_s: float) -> None:
        linear, angular = self.speed = tuple(
            speed + max(-limit * duration_s, min(aim - speed, limit * duration_s))
            for speed, aim, limit in zip(self.speed, self.command, MAX_ACCELERATION, strict=True)
        )  # type: ignore[assignment]
        half = angular * TRACK_M / 2.0
        turns = np.array([linear - half, linear + half]) / WHEEL_RADIUS_M * duration_s
        self.wheels += turns
        self.odometry = self.odometry @ arc(turns * WHEEL_RADIUS_M, TRACK_M)
        ways = turns * self.radii
        ways += self.random.normal(0.0, 1.0, 2) * self.slip * np.sqrt(np.abs(ways))
        self._move(self.truth @ arc(ways, self.track))

    def _move(self, pose: Pose2D) -> None:
        """Move to a pose, unless something is in the way; the robot is round, so it can turn everywhere."""
        clearance = self.room.clearance(pose.x, pose.y)
        self.is_blocked = (
            clearance < BODY_RADIUS_M and clearance < self.room.clearance(self.truth.x, self.truth.y) - 1e-9
        )
        self.truth = Pose2D(self.truth.x, self.truth.y, pose.yaw) if self.is_blocked else pose


def arc(ways: np.ndarray, track: float) -> Pose2D:
    """Return the movement of a robot whose left and right wheel rolled so far [m]: on an arc of a circle."""
    left, right = ways.tolist()
    way, yaw = (left + right) / 2.0, (right - left) / track
    chord = way * (math.sin(yaw / 2.0) / (yaw / 2.0) if abs(yaw) > 1e-9 else 1.0)
    return Pose2D(chord * math.cos(yaw / 2.0), chord * math.sin(yaw / 2.0), yaw)
