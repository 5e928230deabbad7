"""Paths and polygons, as lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from tfloom.viewer.displays.display import finite_points, stamp_of
from tfloom.viewer.shapes import Lines, Placed

__all__ = ["line_strip", "shapes_of_path", "shapes_of_polygon"]

MAX_POINTS = 50_000
"""Number of a path's points that are drawn; of more, every second one is, or every third."""
GREEN = np.array((60, 220, 90), np.uint8)
ORANGE = np.array((255, 170, 40), np.uint8)


def line_strip(points: Any) -> Any:
    """Return the lines between neighbouring points (N - 1, 2, 3)."""
    return np.stack([points[:-1], points[1:]], axis=1)


def shapes_of_path(message: Any) -> list[Placed]:
    """Return the line of a `nav_msgs/msg/Path`.

    The poses' own headers are not read, as RViz doesn't: they are in the frame of the path.
    """
    step = -(-len(message.poses) // MAX_POINTS) or 1
    points = finite_points([stamped.pose.position for stamped in message.poses[::step]])
    if len(points) < 2:
        return []
    return [Placed(Lines(line_strip(points), GREEN), message.header.frame_id, stamp_of(message.header))]


def shapes_of_polygon(message: Any) -> list[Placed]:
    """Return the closed line of a `geometry_msgs/msg/PolygonStamped`."""
    points = finite_points(message.polygon.points[:MAX_POINTS])
    if len(points) < 2:
        return []
    ends = line_strip(np.concatenate([points, points[:1]]))
    return [Placed(Lines(ends, ORANGE), message.header.frame_id, stamp_of(message.header))]
