"""Models of lens distortion, and the maps and points of rectified images.

The model is OpenCV's, whose first five coefficients are `plumb_bob`, whose first eight are `rational_polynomial`. For a
point (x, y) of the plane at depth 1, with r^2 = x^2 + y^2:

    q = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
    x' = x q + 2 p1 x y + p2 (r^2 + 2 x^2) + s1 r^2 + s2 r^4
    y' = y q + p1 (r^2 + 2 y^2) + 2 p2 x y + s3 r^2 + s4 r^4

followed by the homography of a sensor tilted by the angles tau_x and tau_y. Source: OpenCV's documentation, module
calib3d, "Camera Calibration and 3D Reconstruction". Undistortion is by fixed-point iteration, as in `undistortPoints`.

The model `equidistant`, of fisheye lenses, bends rays by their angle from the axis, theta = atan(r):

    theta' = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8),    (x', y') = (x, y) theta' / r

Source: the same, "Fisheye camera model"; J. Kannala and S. Brandt, "A generic camera model and calibration method for
conventional, wide-angle, and fish-eye lenses", 2006.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

__all__ = ["Distortion", "Equidistant", "Lens", "rectification_maps", "undistort_points"]

Floats = NDArray[Any]

_LENGTHS = (0, 4, 5, 8, 12, 14)
_ITERATIONS = 5
"""The default of `undistortPoints`."""
_NEWTON_STEPS = 20
_TOLERANCE = 1e-8
"""Largest error of an angle [rad]."""


class Distortion:
    """A lens's distortion.

    Args:
        coefficients: k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y [rad]: the first 4, 5, 8, 12 or 14 of
            them, or none.

    Raises:
        ValueError: there is another number of them.
    """

    def __init__(self, coefficients: Floats | None) -> None:
        given = np.zeros(0) if coefficients is None else np.asarray(coefficients, np.float64).reshape(-1)
        if given.size not in _LENGTHS:
            raise ValueError(f"a distortion has 4, 5, 8, 12 or 14 coefficients, or none, not {given.size}")
        k1, k2, self.p1, self.p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y = np.pad(
            given, (0, 14 - given.size)
        )
        self._above = (k1, k2, k3)
        self._below = (k4, k5, k6)
        self._prism = (s1, s2, s3, s4)
        self._tilt = _tilt(tau_x, tau_y)

    def apply(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Return where points of the plane at depth 1 appear on it through the lens; of any shape."""
        r2 = x * x + y * y
        ratio = _polynomial(r2, self._above) / _polynomial(r2, self._below)
        dx, dy = self._shift(x, y, r2)
        return _project(self._tilt, x * ratio + dx, y * ratio + dy)

    def remove(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Return the points that `apply` maps to x and y, by fixed-point iteration; of any shape."""
        x, y = _project(np.linalg.inv(self._tilt), x, y)
        x0, y0 = x, y
        diverged = np.zeros(x.shape, bool)
        for _ in range(_ITERATIONS):
            r2 = x * x + y * y
            inverse = _polynomial(r2, self._below) / _polynomial(r2, self._above)
            diverged |= inverse < 0  # outside of the invertible region: the point stays
            dx, dy = self._shift(x, y, r2)
            x = np.where(diverged, x0, (x0 - dx) * inverse)
            y = np.where(diverged, y0, (y0 - dy) * inverse)
        return x, y

    def _shift(self, x: Floats, y: Floats, r2: Floats) -> tuple[Floats, Floats]:
        s1, s2, s3, s4 = self._prism
        dx = 2 * self.p1 * x * y + self.p2 * (r2 + 2 * x * x) + s1 * r2 + s2 * r2 * r2
        dy = self.p1 * (r2 + 2 * y * y) + 2 * self.p2 * x * y + s3 * r2 + s4 * r2 * r2
        return dx, dy


class Equidistant:
    """A fisheye lens.

    Args:
        coefficients: k1, k2, k3, k4.

    Raises:
        ValueError: there is another number of them.
    """

    def __init__(self, coefficients: Floats | None) -> None:
        given = np.zeros(4) if coefficients is None else np.asarray(coefficients, np.float64).reshape(-1)
        if given.size != 4:
            raise ValueError(f"an equidistant lens has 4 coefficients, not {given.size}")
        self._powers = np.array([1.0, *given])
        """Coefficients of theta, theta^3, theta^5, theta^7 and theta^9."""

    def apply(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Return where points of the plane at depth 1 appear on it through the lens; of any shape."""
        r = np.hypot(x, y)
        theta = np.arctan(r)
        scale = np.divide(self._bend(theta), r, out=np.ones_like(r), where=r > 0)
        return x * scale, y * scale

    def remove(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Return the points that `apply` maps to x and y, by Newton's method; of any shape. NaN if there is none."""
        bent = np.hypot(x, y)
        theta = bent.copy()
        odd = np.arange(1, 10, 2)
        for _ in range(_NEWTON_STEPS):
            slope = ((odd * self._powers) * theta[..., None] ** (odd - 1)).sum(-1)
            theta = theta - np.divide(
                self._bend(theta) - bent, slope, out=np.zeros_like(theta), where=slope != 0
            )
        found = (np.abs(self._bend(theta) - bent) < _TOLERANCE) & (theta >= 0) & (theta < math.pi / 2)
        scale = np.divide(np.tan(theta), bent, out=np.ones_like(bent), where=bent > 0)
        scale = np.where(found, scale, np.nan)
        return x * scale, y * scale

    def _bend(self, theta: Floats) -> Floats:
        square = theta * theta
        bent: Floats = theta * np.polynomial.polynomial.polyval(square, self._powers)
        return bent


Lens: TypeAlias = Distortion | Equidistant


def _polynomial(r2: Floats, coefficients: tuple[float, float, float]) -> Floats:
    first, second, third = coefficients
    value: Floats = 1 + ((third * r2 + second) * r2 + first) * r2
    return value


def _tilt(tau_x: float, tau_y: float) -> Floats:
    """Return the homography of a tilted sensor: the rotation about x and then y, projected along the optical axis."""
    if not tau_x and not tau_y:
        return np.eye(3)
    about_x = np.array(
        [[1, 0, 0], [0, math.cos(tau_x), math.sin(tau_x)], [0, -math.sin(tau_x), math.cos(tau_x)]]
    )
    about_y = np.array(
        [[math.cos(tau_y), 0, -math.sin(tau_y)], [0, 1, 0], [math.sin(tau_y), 0, math.cos(tau_y)]]
    )
    rotation = about_y @ about_x
    projection = np.array(
        [[rotation[2, 2], 0, -rotation[0, 2]], [0, rotation[2, 2], -rotation[1, 2]], [0, 0, 1]]
    )
    tilt: Floats = projection @ rotation
    return tilt


def _project(homography: Floats, x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Return points of the plane at depth 1, mapped by a homography (3, 3)."""
    u, v, w = (row[0] * x + row[1] * y + row[2] for row in homography)
    with np.errstate(divide="ignore", invalid="ignore"):
        return u / w, v / w


def undistort_points(uv: Floats, k: Floats, lens: Lens, r: Floats, p: Floats) -> Floats:
    """Return pixels (N, 2) of the raw image as pixels (N, 2) of the rectified image.

    Args:
        uv: Pixels (N, 2): column and row.
        k: Camera matrix (3, 3) of the raw image.
        lens: The lens.
        r: Rotation (3, 3) from the raw camera to the rectified one.
        p: Projection matrix (3, 4) of the rectified image.
    """
    x = (uv[:, 0] - k[0, 2]) / k[0, 0]
    y = (uv[:, 1] - k[1, 2]) / k[1, 1]
    return np.column_stack(_project(p[:, :3] @ r, *lens.remove(x, y)))


def rectification_maps(
    k: Floats, lens: Lens, r: Floats, p: Floats, size: tuple[int, int]
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the position in the raw image of each pixel of the rectified image.

    Args:
        k: Camera matrix (3, 3) of the raw image.
        lens: The lens.
        r: Rotation (3, 3) from the raw camera to the rectified one.
        p: Projection matrix (3, 4) of the rectified image.
        size: Width and height of the rectified image [px].

    Returns:
        Columns and rows, each (height, width) of float32.
    """
    width, height = size
    rows, columns = np.mgrid[:height, :width].astype(np.float64)
    x, y = lens.apply(*_project(np.linalg.inv(p[:, :3] @ r), columns, rows))
    return (x * k[0, 0] + k[0, 2]).astype(np.float32), (y * k[1, 1] + k[1, 2]).astype(np.float32)
