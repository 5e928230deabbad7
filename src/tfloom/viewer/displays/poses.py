"""Poses, arrays of them, points, paths and polygons, and odometry, with the covariance of a position."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import finite_points, pose_of, shown_text, stamp_of
from tfloom.viewer.shapes import Arrows, Axes, Ball, Color, DisplayError, Lines, Placed, Text

__all__ = [
    "line_strip",
    "shapes_of_odometry",
    "shapes_of_path",
    "shapes_of_point",
    "shapes_of_polygon",
    "shapes_of_pose",
    "shapes_of_pose_array",
    "shapes_of_pose_with_covariance",
]

MAX_POSES = 20_000
"""Number of an array's poses that are drawn."""
ARROW_LENGTH_M = 0.5
RED: Color = (255, 60, 60)
YELLOW: Color = (255, 210, 60)
VIOLET: Color = (200, 90, 255)
COVARIANCE_OPACITY = 0.3
MAX_SPEED = 30
"""Number of characters of a speed that are drawn."""
MAX_VARIANCE_M2 = 1e12
"""Least variance of a position that says nothing [m²]."""
MAX_RADIUS_M = 1000.0
"""Radius of the largest ellipsoid of a covariance that is drawn [m]."""
MAX_POINTS = 50_000
"""Number of a path's points that are drawn; of more, every second one is, or every third."""
GREEN = np.array((60, 220, 90), np.uint8)
ORANGE = np.array((255, 170, 40), np.uint8)


def _arrow(pose: Any, header: Any, color: Color) -> Placed:
    position, rotation = pose_of(pose)
    ends = np.array([[(0.0, 0.0, 0.0), (ARROW_LENGTH_M, 0.0, 0.0)]], np.float32)
    return Placed(Arrows(ends, color), header.frame_id, stamp_of(header), position, rotation)


def _ellipsoid(pose: Any, header: Any, covariance: Any) -> list[Placed]:
    """Return the ellipsoid of one standard deviation; none where the covariance is zero or no covariance."""
    matrix = np.asarray(covariance, np.float64).reshape(6, 6)[:3, :3]
    if not ((np.abs(matrix) < MAX_VARIANCE_M2).all() and matrix.any()):
        return []
    variances, directions = np.linalg.eigh((matrix + matrix.T) / 2.0)
    if variances[0] < -1e-6 * max(variances[2], 1.0):
        return []
    radii = np.clip(np.sqrt(np.maximum(variances, 0.0)), 0.005, MAX_RADIUS_M)
    if np.linalg.det(directions) < 0.0:
        directions[:, 0] = -directions[:, 0]
    turned = np.eye(4)
    turned[:3, :3] = directions
    rotation = Transform.from_matrix(turned.tolist()).rotation_xyzw
    # The covariance of a position is along the axes of the header's frame, not along those of the pose.
    position, _ = pose_of(pose)
    ball = Ball((float(radii[0]), float(radii[1]), float(radii[2])), VIOLET, COVARIANCE_OPACITY)
    return [Placed(ball, header.frame_id, stamp_of(header), position, rotation)]


def shapes_of_pose(message: Any) -> list[Placed]:
    """Return the arrow of a `geometry_msgs/msg/PoseStamped`."""
    return [_arrow(message.pose, message.header, RED)]


def shapes_of_pose_with_covariance(message: Any) -> list[Placed]:
    """Return arrow and ellipsoid of a `geometry_msgs/msg/PoseWithCovarianceStamped`."""
    pose, header = message.pose.pose, message.header
    return [_arrow(pose, header, YELLOW), *_ellipsoid(pose, header, message.pose.covariance)]


def shapes_of_odometry(message: Any) -> list[Placed]:
    """Return arrow, ellipsoid and speed of a `nav_msgs/msg/Odometry`."""
    pose, header = message.pose.pose, message.header
    shapes = [_arrow(pose, header, YELLOW), *_ellipsoid(pose, header, message.pose.covariance)]
    linear = message.twist.twist.linear
    speed = math.hypot(float(linear.x), float(linear.y), float(linear.z))
    if math.isfinite(speed):
        (x, y, z), _ = pose_of(pose)
        place = (x, y, z + 0.3)
        shapes.append(
            Placed(
                Text(shown_text(f"{speed:.2f} m/s", MAX_SPEED), 0.15),
                header.frame_id,
                stamp_of(header),
                place,
            )
        )
    return shapes


def shapes_of_pose_array(message: Any) -> list[Placed]:
    """Return the axes of a `geometry_msgs/msg/PoseArray`; poses with numbers that are not finite are left out."""
    positions, rotations = [], []
    for pose in message.poses[:MAX_POSES]:
        try:
            position, rotation = pose_of(pose)
        except DisplayError:
            continue
        positions.append(position)
        rotations.append(rotation)
    if not positions:
        return []
    axes = Axes(np.array(positions, np.float32), np.array(rotations, np.float32))
    return [Placed(axes, message.header.frame_id, stamp_of(message.header))]


def shapes_of_point(message: Any) -> list[Placed]:
    """Return the ball of a `geometry_msgs/msg/PointStamped`."""
    points = finite_points([message.point])
    ball = Ball((0.1, 0.1, 0.1), VIOLET)
    return [
        Placed(ball, message.header.frame_id, stamp_of(message.header), (float(x), float(y), float(z)))
        for x, y, z in points
    ]


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
