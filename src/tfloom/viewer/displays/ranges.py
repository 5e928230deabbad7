"""What a range sensor sees: a cone."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tfloom.viewer.displays.display import stamp_of
from tfloom.viewer.shapes import DisplayError, Mesh, Placed

__all__ = ["shapes_of_range"]

SIDES = 24
"""Number of a cone's sides."""
BLUE = (80, 160, 255)


def shapes_of_range(message: Any) -> list[Placed]:
    """Return the cone of a `sensor_msgs/msg/Range`, up to what it measured.

    Raises:
        DisplayError: its field of view is none.
    """
    distance, field = float(message.range), float(message.field_of_view)
    if not (math.isfinite(field) and 0.0 < field < math.pi):
        raise DisplayError(f"its field of view is {field:g} rad, and has to be between 0 and pi")
    if not (math.isfinite(distance) and 0.0 < distance < 1e6):
        return []  # nothing was hit
    radius = distance * math.tan(field / 2.0)
    angles = np.arange(SIDES) * (2.0 * math.pi / SIDES)
    rim = np.stack([np.full(SIDES, distance), radius * np.cos(angles), radius * np.sin(angles)], axis=1)
    vertices = np.vstack([np.zeros((1, 3)), rim]).astype(np.float32)
    first = np.arange(SIDES)
    faces = np.stack([np.zeros(SIDES), first + 1, (first + 1) % SIDES + 1], axis=1).astype(np.uint32)
    cone = Mesh(vertices, faces, BLUE, opacity=0.4)
    return [Placed(cone, message.header.frame_id, stamp_of(message.header))]
