"""Velocities by differences of transforms: a correct twist, and tf2's lookupVelocity unchanged."""

from __future__ import annotations

from typing import NamedTuple

from tfloom._native import Transform
from tfloom.tf2.arrays import Arrays
from tfloom.tf2.errors import TransformException

__all__ = ["Twist", "Velocities"]

Triple = tuple[float, float, float]

EARLIEST_S = 1e-5


class Twist(NamedTuple):
    """Velocity of a frame."""

    linear: Triple
    """Velocity of its origin [m/s]."""
    angular: Triple
    """Its rotation vector [rad/s]."""


class Velocities(Arrays):
    """The part of a buffer that differentiates."""

    def velocity(
        self,
        body_frame: str,
        fixed_frame: str,
        stamp_ns: int = 0,
        *,
        interval_ns: int = 100_000_000,
        axes_frame: str | None = None,
    ) -> Twist:
        """Return the velocity of `body_frame` in `fixed_frame`: linear, of its origin, and angular.

        Both are means over the interval around `stamp_ns`, which is shifted back if it ends after the newest data.

        Args:
            body_frame: The frame that moves.
            fixed_frame: The frame of reference.
            stamp_ns: Time of the velocity [ns since epoch]; 0 is the latest.
            interval_ns: Time over which to take the mean [ns].
            axes_frame: Frame in whose axes the vectors are expressed; None: `fixed_frame`.

        Raises:
            TransformException: as `lookup`.
            ValueError: the interval is not positive.
        """
        if interval_ns <= 0:
            raise ValueError("interval_ns must be positive")
        latest = self.latest_common_time(fixed_frame, body_frame)
        if latest == 0:  # all of it static
            return Twist((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
        end_ns = min((stamp_ns or latest) + interval_ns // 2, latest)
        linear, angular = self._difference(fixed_frame, body_frame, end_ns - interval_ns, end_ns)
        if axes_frame is None:
            return Twist(linear, angular)
        turn = _turn(self.lookup(axes_frame, fixed_frame, stamp_ns).transform)
        return Twist(turn.apply(linear), turn.apply(angular))

    def lookup_velocity(
        self,
        tracking_frame: str,
        observation_frame: str,
        stamp_ns: int,
        interval_s: float,
        *,
        reference_frame: str | None = None,
        reference_point: Triple = (0.0, 0.0, 0.0),
        reference_point_frame: str | None = None,
    ) -> Twist:
        """Return the result of tf2's lookupVelocity, by its formula; `velocity` returns a correct twist.

        Its differences from a twist: the velocity is turned by reference-from-tracking, not -from-observation, and
        the reference point adds the product of the components of ω and the arm, not their cross product.

        Args:
            tracking_frame: The frame that moves.
            observation_frame: The frame of reference.
            stamp_ns: Time of the velocity [ns since epoch].
            interval_s: Time over which to take the mean [s].
            reference_frame: Frame of the result; None: `observation_frame`.
            reference_point: A point of the moving body [m].
            reference_point_frame: The frame of that point; None: `tracking_frame`.

        Raises:
            TransformException: as `lookup`.
        """
        reference = observation_frame if reference_frame is None else reference_frame
        # The interval has the stamp in its middle, but ends no later than the newest time that is known. It begins no
        # earlier than EARLIEST_S, and is shorter then: as time 0, a start would ask for the latest transform.
        try:
            latest_s = self.latest_common_time(observation_frame, tracking_frame) / 1e9
        except TransformException:
            latest_s = 0.0
        end_s = min(stamp_ns / 1e9 + interval_s * 0.5, latest_s)
        start_s = max(EARLIEST_S + interval_s, end_s) - interval_s
        linear, angular = self._difference(
            observation_frame, tracking_frame, round(start_s * 1e9), round(end_s * 1e9)
        )
        # Into the axes of the reference frame, by the turn that tf2 takes; then from the tracking frame's origin to the
        # reference frame's, where the moving body has the velocity v plus the cross product of p and ω.
        moved = self.lookup(reference, tracking_frame, stamp_ns).transform
        turn = _turn(moved)
        angular = turn.apply(angular)
        linear = _sum(turn.apply(linear), _cross(moved.translation, angular))
        # At last to the point that was asked for, with tf2's product in place of the cross product of ω and the arm.
        point_frame = tracking_frame if reference_point_frame is None else reference_point_frame
        point = self.lookup(reference, point_frame, stamp_ns).transform.apply(reference_point)
        arm = _difference(point, moved.translation)
        product = (angular[0] * arm[0], angular[1] * arm[1], angular[2] * arm[2])
        return Twist(_sum(linear, product), angular)

    def _difference(self, target: str, source: str, start_ns: int, end_ns: int) -> tuple[Triple, Triple]:
        """Return the mean linear and angular velocity of `source` in `target` [m/s, rad/s]."""
        start = self.lookup(target, source, start_ns).transform
        end = self.lookup(target, source, end_ns).transform
        duration_s = (end_ns - start_ns) / 1e9
        axis, angle = (_turn(start).inverse() @ _turn(end)).axis_angle
        angular = _turn(start).apply(axis)
        return (
            _scaled(_difference(end.translation, start.translation), 1 / duration_s),
            _scaled(angular, angle / duration_s),
        )


def _turn(transform: Transform) -> Transform:
    return Transform((0.0, 0.0, 0.0), transform.rotation_xyzw)


def _scaled(a: Triple, factor: float) -> Triple:
    return a[0] * factor, a[1] * factor, a[2] * factor


def _sum(a: Triple, b: Triple) -> Triple:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _difference(a: Triple, b: Triple) -> Triple:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
