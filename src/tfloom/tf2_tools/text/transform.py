"""A transform as tf2_echo prints it: numbers, angles and the matrix, three decimals each."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
"""Rows of a rotation."""


def matrix_from_quaternion(rotation_xyzw: Sequence[float]) -> Matrix:
    """Return the rotation matrix of a quaternion of any length but 0."""
    x, y, z, w = rotation_xyzw
    s = 2.0 / (x * x + y * y + z * z + w * w)
    return (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )


def rpy_from_matrix(matrix: Matrix) -> tuple[float, float, float]:
    """Return roll, pitch and yaw [rad], about the fixed axes x, y and z in this order.

    Where the pitch is ±π/2, roll and yaw turn about the same axis: the yaw is 0 then.
    """
    (m00, m01, m02), (m10, _, _), (m20, m21, m22) = matrix
    if abs(m20) >= 1.0:
        pitch = math.copysign(math.pi / 2, -m20)
        roll = math.atan2(m01, m02) if m20 < 0 else math.atan2(-m01, -m02)
        return roll, pitch, 0.0
    return math.atan2(m21, m22), -math.asin(m20), math.atan2(m10, m00)


def transform_text(stamp_ns: int, translation: Sequence[float], rotation_xyzw: Sequence[float]) -> str:
    """Return the lines that tf2_echo prints for a transform.

    Args:
        stamp_ns: Its time [ns since epoch].
        translation: x, y, z [m].
        rotation_xyzw: Quaternion.
    """
    matrix = matrix_from_quaternion(rotation_xyzw)
    rpy = rpy_from_matrix(matrix)
    seconds, nanoseconds = divmod(stamp_ns, 1_000_000_000)
    rows = [(*row, along) for row, along in zip(matrix, translation, strict=True)]
    return "\n".join(
        [
            f"At time {seconds}.{nanoseconds:09d}",
            f"- Translation: {_bracketed(translation)}",
            f"- Rotation: in Quaternion {_bracketed(rotation_xyzw)}",
            f"- Rotation: in RPY (radian) {_bracketed(rpy)}",
            f"- Rotation: in RPY (degree) {_bracketed(map(math.degrees, rpy))}",
            "- Matrix:",
            *("".join(f" {cell:6.3f}" for cell in row) for row in [*rows, (0.0, 0.0, 0.0, 1.0)]),
        ]
    )


def _bracketed(numbers: Iterable[float]) -> str:
    return "[" + ", ".join(f"{number:.3f}" for number in numbers) + "]"
