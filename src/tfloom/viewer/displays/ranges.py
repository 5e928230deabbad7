"""What sensors of ranges see: a cone, or the points of a laser scan, in the plane of the laser."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.viewer.displays.display import stamp_of
from tfloom.viewer.displays.point_cloud import PointsDisplay
from tfloom.viewer.shapes import DisplayError, Mesh, Placed

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

__all__ = ["LaserScanDisplay", "shapes_of_range"]

SIDES = 24
"""Number of a cone's sides."""
MAX_BEAMS = 100_000
"""Number of beams that are drawn."""


def shapes_of_range(message: Any, settings: Values) -> list[Placed]:
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
    cone = Mesh(vertices, faces, settings["color"], settings["opacity"])
    return [Placed(cone, message.header.frame_id, stamp_of(message.header))]


class LaserScanDisplay(PointsDisplay):
    """Shows the points that a `sensor_msgs/msg/LaserScan` hit, by their intensities if it has these."""

    usual_fields = ("intensity",)

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return the points."""
        ranges = np.asarray(message.ranges, np.float64)[:MAX_BEAMS]
        with np.errstate(invalid="ignore", over="ignore"):
            angles = message.angle_min + message.angle_increment * np.arange(len(ranges))
            positions = np.stack(
                [ranges * np.cos(angles), ranges * np.sin(angles), np.zeros(len(ranges))], axis=1
            )
            # Beyond its limits a scan has no measurements, and beyond float32 a page has no numbers.
            is_hit = (ranges >= message.range_min) & (ranges <= message.range_max)
            is_hit &= (np.abs(positions) < 1e9).all(axis=1)
            intensities = np.asarray(message.intensities, np.float64)
            fields = {"range": ranges[is_hit]}
            if len(intensities) >= len(ranges) > 0 and np.ptp(intensities[: len(ranges)]) > 0.0:
                fields = {"intensity": intensities[: len(ranges)][is_hit], **fields}
        return self.drawn(positions[is_hit].astype(np.float32), fields, message.header)
