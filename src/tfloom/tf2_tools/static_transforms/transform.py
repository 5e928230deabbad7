"""A static transform, and its rotation from three angles."""

from __future__ import annotations

import math
from typing import NamedTuple

__all__ = ["StaticTransform", "quaternion_from_rpy"]


class StaticTransform(NamedTuple):
    """A transform that never changes: frame_from_child."""

    frame_id: str
    child_frame_id: str
    translation: tuple[float, float, float]
    """[m]."""
    rotation_xyzw: tuple[float, float, float, float]


def quaternion_from_rpy(
    roll_rad: float, pitch_rad: float, yaw_rad: float
) -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of turns about the fixed axes x, y and z, in this order."""
    cr, sr = math.cos(roll_rad / 2), math.sin(roll_rad / 2)
    cp, sp = math.cos(pitch_rad / 2), math.sin(pitch_rad / 2)
    cy, sy = math.cos(yaw_rad / 2), math.sin(yaw_rad / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )
