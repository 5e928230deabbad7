"""What a range sensor and a camera see: a cone, and a pyramid."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tfloom.viewer.displays.display import stamp_of
from tfloom.viewer.shapes import DisplayError, Lines, Mesh, Placed

__all__ = ["shapes_of_camera", "shapes_of_range"]

SIDES = 24
"""Number of a cone's sides."""
FRUSTUM_M = 0.5
"""Length of a camera's pyramid [m]."""
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


def shapes_of_camera(message: Any) -> list[Placed]:
    """Return the pyramid of a `sensor_msgs/msg/CameraInfo`: what its picture shows, at half a metre.

    Raises:
        DisplayError: it is not calibrated.
    """
    width, height = float(message.width), float(message.height)
    fx, _, cx, _, fy, cy = (float(number) for number in message.k[:6])
    is_finite = all(map(math.isfinite, (fx, fy, cx, cy)))
    if not (is_finite and fx > 0.0 and fy > 0.0 and width > 0.0 and height > 0.0):
        raise DisplayError("it is not calibrated: its focal lengths and sizes have to be above zero")
    corners = np.array(
        [
            ((u - cx) / fx * FRUSTUM_M, (v - cy) / fy * FRUSTUM_M, FRUSTUM_M)
            for u, v in ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))
        ]
    )
    edges = [(np.zeros(3), corner) for corner in corners]
    edges += [(corners[number], corners[(number + 1) % 4]) for number in range(4)]
    lines = Lines(np.clip(np.array(edges), -1e6, 1e6).astype(np.float32), np.array(BLUE, np.uint8))
    return [Placed(lines, message.header.frame_id, stamp_of(message.header))]
