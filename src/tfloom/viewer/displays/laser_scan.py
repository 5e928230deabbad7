"""Laser scans, as points in the plane of the laser."""

from __future__ import annotations

from typing import Any

import numpy as np

from tfloom.viewer.displays.display import rainbow, stamp_of
from tfloom.viewer.shapes import Placed, Points

__all__ = ["shapes_of_scan"]

MAX_BEAMS = 100_000
"""Number of beams that are drawn."""
RED = np.array((255, 70, 70), np.uint8)


def shapes_of_scan(message: Any) -> list[Placed]:
    """Return the points that a `sensor_msgs/msg/LaserScan` hit, by their intensities if it has these."""
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
        has_intensities = len(intensities) >= len(ranges) > 0 and np.ptp(intensities[: len(ranges)]) > 0.0
    colors = rainbow(intensities[: len(ranges)][is_hit]) if has_intensities else RED
    if not is_hit.any():
        return []
    shape = Points(positions[is_hit].astype(np.float32), colors, size_m=0.05)
    return [Placed(shape, message.header.frame_id, stamp_of(message.header))]
