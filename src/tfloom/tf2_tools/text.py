"""Counts, durations, ages and transforms as texts."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

__all__ = [
    "NS_PER_S",
    "Matrix",
    "ago",
    "counted",
    "matrix_from_quaternion",
    "rpy_from_matrix",
    "seconds_text",
    "transform_text",
]

NS_PER_S = 1e9


def counted(count: int, noun: str) -> str:
    """Return a count with its noun in the singular or plural."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def seconds_text(duration_s: float) -> str:
    """Return a duration in seconds with as many digits as matter: three below 1 s, two below 100 s."""
    if abs(duration_s) < 1.0:
        return f"{duration_s:.3f} s"
    return f"{duration_s:.2f} s" if abs(duration_s) < 100.0 else f"{duration_s:.0f} s"


def ago(stamp_ns: int, now_ns: int) -> str:
    """Return how long ago a stamp is, or how far ahead."""
    age_s = (now_ns - stamp_ns) / NS_PER_S
    return f"{seconds_text(age_s)} ago" if age_s >= 0.0 else f"{seconds_text(-age_s)} ahead"


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
