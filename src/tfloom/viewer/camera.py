"""From a place on the screen to a place on the floor, and from places to the screen."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tfloom.tf2.transform import Transform

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Camera", "direction_of", "floor_point", "is_usable", "projected"]

MAX_DISTANCE_M = 1e4
"""A point on the floor that is further away is none: the ray is all but parallel to the floor."""
MAX_NUMBER = 1e9
"""Least number that a camera can't have."""
MIN_LENGTH = 1e-6
"""Length of a quaternion up to which it has no direction."""


class Camera(NamedTuple):
    """A page's camera, which looks along its z axis; its x axis is to the right, its y axis down."""

    position: tuple[float, float, float]
    rotation_xyzw: tuple[float, float, float, float]
    fov_rad: float
    """Vertical field of view."""
    aspect: float
    """Width by height of the picture."""


def is_usable(
    position: Sequence[float],
    look_at: Sequence[float],
    rotation_wxyz: Sequence[float],
    fov_rad: float,
    aspect: float,
) -> bool:
    """Return whether what a page says of its camera is a camera: near, turned by a rotation, and with a view.

    Raises:
        TypeError, ValueError: something is not a number.
    """
    numbers = (*position, *look_at, *rotation_wxyz, fov_rad, aspect)
    return (
        (len(position), len(look_at), len(rotation_wxyz)) == (3, 3, 4)
        and all(abs(float(number)) < MAX_NUMBER for number in numbers)
        and math.hypot(*rotation_wxyz) > MIN_LENGTH
        and 0.0 < fov_rad < math.pi
        and aspect > 0.0
    )


def direction_of(camera: Camera, across: float, down: float) -> tuple[float, float, float]:
    """Return the direction in which a place on the screen is seen, 1 long along the camera's axis.

    Args:
        camera: The camera.
        across: From 0 at the left edge to 1 at the right edge.
        down: From 0 at the upper edge to 1 at the lower edge.
    """
    half = math.tan(camera.fov_rad / 2.0)
    ray = ((2.0 * across - 1.0) * half * camera.aspect, (2.0 * down - 1.0) * half, 1.0)
    return Transform(rotation_xyzw=camera.rotation_xyzw).apply(ray)


def projected(camera: Camera, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where points are on the screen (N, 3): across and down, as of `direction_of`, and how far ahead [m].

    Args:
        camera: The camera.
        points: (N, 3) [m]. Those that are not ahead of the camera have no place: across and down are NaN.
    """
    turned = Transform(rotation_xyzw=camera.rotation_xyzw)
    axes = np.array([turned.apply(axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))])
    seen = (points - np.array(camera.position)) @ axes.T
    half = math.tan(camera.fov_rad / 2.0)
    ahead_m = np.where(seen[:, 2] > 0.0, seen[:, 2], np.nan)
    across = (seen[:, 0] / ahead_m / (half * camera.aspect) + 1.0) / 2.0
    down = (seen[:, 1] / ahead_m / half + 1.0) / 2.0
    return np.stack([across, down, seen[:, 2]], axis=1)


def floor_point(camera: Camera, across: float, down: float) -> tuple[float, float] | None:
    """Return the point of the plane z = 0 that a place on the screen shows (x, y) [m]; None if it shows none.

    Args:
        camera: The camera.
        across: From 0 at the left edge to 1 at the right edge.
        down: From 0 at the upper edge to 1 at the lower edge.
    """
    x, y, z = direction_of(camera, across, down)
    if z * camera.position[2] >= 0.0:  # the ray leaves the floor behind, or the camera is within it
        return None
    factor = -camera.position[2] / z
    if not factor * math.hypot(x, y) < MAX_DISTANCE_M:
        return None
    return camera.position[0] + factor * x, camera.position[1] + factor * y
