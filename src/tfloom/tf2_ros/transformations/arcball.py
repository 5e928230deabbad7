"""Rotation with the mouse, by tf_transformations' names: a virtual trackball."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tfloom.tf2_ros.transformations.transformations import (
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
    unit_vector,
)

__all__ = ["Arcball", "arcball_constrain_to_axis", "arcball_map_to_sphere", "arcball_nearest_axis"]

Vector = NDArray[np.float64]

NOTHING = float(np.finfo(float).eps) * 4


class Arcball:
    """A virtual trackball (K. Shoemake, "ARCBALL", Graphics Interface 1992).

    Window coordinates are in pixels, y downwards. A drag rotates by twice the angle that the cursor covers on the ball.

    Args:
        initial: Initial rotation: a quaternion (x, y, z, w), or a matrix (4, 4); None: the identity.

    Raises:
        ValueError: `initial` is neither.
    """

    def __init__(self, initial: ArrayLike | None = None) -> None:
        start = np.array([0, 0, 0, 1] if initial is None else initial, np.float64)
        if start.shape == (4, 4):
            start = quaternion_from_matrix(start)
        elif start.shape != (4,):
            raise ValueError("initial not a quaternion or matrix.")
        self._now = self._before = self._at_down = unit_vector(start)
        self._down = np.array([0.0, 0.0, 1.0])
        self._center, self._radius = (0.0, 0.0), 1.0
        self._axes: list[Vector] | None = None
        self._axis: Vector | None = None
        self._is_constrained = False

    def place(self, center: Sequence[float], radius: float) -> None:
        """Set the ball's centre and radius in the window."""
        self._center, self._radius = (float(center[0]), float(center[1])), float(radius)

    def setaxes(self, *axes: ArrayLike) -> None:
        """Set the axes to which drags are constrained while `setconstrain` is on; without axes they are free."""
        self._axes = [unit_vector(axis) for axis in axes] or None

    def setconstrain(self, constrain: bool) -> None:
        """Set whether the next drag rotates about the nearest of the axes only."""
        self._is_constrained = constrain is True

    def getconstrain(self) -> bool:
        """Return whether drags are constrained to the axes."""
        return self._is_constrained

    def down(self, point: Sequence[float]) -> None:
        """Begin a drag at the cursor."""
        self._down = arcball_map_to_sphere(point, self._center, self._radius)
        self._at_down = self._before = self._now
        self._axis = None
        if self._is_constrained and self._axes is not None:
            self._axis = arcball_nearest_axis(self._down, self._axes)
            self._down = arcball_constrain_to_axis(self._down, self._axis)

    def drag(self, point: Sequence[float]) -> None:
        """Continue the drag to the cursor."""
        here = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            here = arcball_constrain_to_axis(here, self._axis)
        self._before = self._now
        across = np.cross(self._down, here)
        if across @ across < NOTHING:
            self._now = self._at_down
        else:
            self._now = quaternion_multiply(np.append(across, self._down @ here), self._at_down)

    def next(self, acceleration: float = 0.0) -> None:
        """Continue the rotation of the last drag."""
        self._before, self._now = self._now, quaternion_slerp(self._before, self._now, 2.0 + acceleration)

    def matrix(self) -> Vector:
        """Return the ball's rotation as a matrix (4, 4)."""
        return quaternion_matrix(self._now)


def arcball_map_to_sphere(point: Sequence[float], center: Sequence[float], radius: float) -> Vector:
    """Return the point of the unit sphere (3,) that is under the cursor, or nearest to it on the rim."""
    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    squared = x * x + y * y
    if squared > 1:
        return np.array([x, y, 0.0]) / math.sqrt(squared)
    return np.array([x, y, math.sqrt(1 - squared)])


def arcball_constrain_to_axis(point: ArrayLike, axis: ArrayLike) -> Vector:
    """Return the point (3,) of the sphere's front that is nearest to `point` on the great circle about an axis."""
    normal, position = np.asarray(axis, np.float64), np.asarray(point, np.float64)
    within = position - normal * (normal @ position)
    length = np.linalg.norm(within)
    if length > NOTHING:
        constrained: Vector = (-within if within[2] < 0 else within) / length
        return constrained
    if normal[2] == 1.0:
        return np.array([1.0, 0.0, 0.0])
    sideways: Vector = unit_vector([-normal[1], normal[0], 0.0])
    return sideways


def arcball_nearest_axis(point: ArrayLike, axes: Iterable[ArrayLike]) -> Vector:
    """Return the axis whose great circle passes nearest to a point of the sphere."""
    position = np.asarray(point, np.float64)
    nearest = max(axes, key=lambda axis: float(arcball_constrain_to_axis(position, axis) @ position))
    return np.asarray(nearest, np.float64)
