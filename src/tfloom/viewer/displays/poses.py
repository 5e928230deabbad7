"""Poses, arrays of them, points, paths and polygons, and odometry, with the covariance of a position."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import finite_points, pose_of, shown_text, stamp_of
from tfloom.viewer.displays.solids import ArrowSizes, arrow_mesh, axes_shapes, line_shape
from tfloom.viewer.shapes import Ball, DisplayError, Placed, Shape, Text

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

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
MAX_SPEED = 30
"""Number of characters of a speed that are drawn."""
MAX_VARIANCE_M2 = 1e12
"""Least variance of a position that says nothing [m²]."""
MAX_RADIUS_M = 1000.0
"""Radius of the largest ellipsoid of a covariance that is drawn [m]."""
MAX_POINTS = 50_000
"""Number of a path's points that are drawn; of more, every second one is, or every third."""
NO_TURN = (0.0, 0.0, 0.0, 1.0)


def _marks(positions: Any, rotations_xyzw: Any, settings: Values) -> list[Shape]:
    """Return an arrow, or axes, for each of many poses."""
    if settings["shape"] == "axes":
        return axes_shapes(
            positions, rotations_xyzw, settings["axes_length"], settings["axes_radius"], settings["opacity"]
        )
    sizes = ArrowSizes(
        *(settings[name] for name in ("shaft_length", "shaft_radius", "head_length", "head_radius"))
    )
    return [arrow_mesh(positions, rotations_xyzw, sizes, settings["color"], settings["opacity"])]


def _mark(pose: Any, header: Any, settings: Values) -> list[Placed]:
    position, rotation = pose_of(pose)
    return [
        Placed(shape, header.frame_id, stamp_of(header), position, rotation)
        for shape in _marks([(0.0, 0.0, 0.0)], [NO_TURN], settings)
    ]


def _ellipsoid(pose: Any, header: Any, covariance: Any, settings: Values) -> list[Placed]:
    """Return the ellipsoid of one standard deviation; none where the covariance is zero or no covariance."""
    matrix = np.asarray(covariance, np.float64).reshape(6, 6)[:3, :3]
    if not (settings["covariance"] and (np.abs(matrix) < MAX_VARIANCE_M2).all() and matrix.any()):
        return []
    variances, directions = np.linalg.eigh((matrix + matrix.T) / 2.0)
    if variances[0] < -1e-6 * max(variances[2], 1.0):
        return []
    radii = settings["covariance_scale"] * np.sqrt(np.maximum(variances, 0.0))
    radii = np.clip(radii, 0.005, MAX_RADIUS_M)
    if np.linalg.det(directions) < 0.0:
        directions[:, 0] = -directions[:, 0]
    turned = np.eye(4)
    turned[:3, :3] = directions
    rotation = Transform.from_matrix(turned.tolist()).rotation_xyzw
    # The covariance of a position is along the axes of the header's frame, not along those of the pose.
    position, _ = pose_of(pose)
    ball = Ball(
        (float(radii[0]), float(radii[1]), float(radii[2])),
        settings["covariance_color"],
        settings["covariance_opacity"],
    )
    return [Placed(ball, header.frame_id, stamp_of(header), position, rotation)]


def shapes_of_pose(message: Any, settings: Values) -> list[Placed]:
    """Return the arrow, or the axes, of a `geometry_msgs/msg/PoseStamped`."""
    return _mark(message.pose, message.header, settings)


def shapes_of_pose_with_covariance(message: Any, settings: Values) -> list[Placed]:
    """Return pose and ellipsoid of a `geometry_msgs/msg/PoseWithCovarianceStamped`."""
    pose, header = message.pose.pose, message.header
    return [
        *_mark(pose, header, settings),
        *_ellipsoid(pose, header, message.pose.covariance, settings),
    ]


def shapes_of_odometry(message: Any, settings: Values) -> list[Placed]:
    """Return pose, ellipsoid and speed of a `nav_msgs/msg/Odometry`."""
    shapes = shapes_of_pose_with_covariance(message, settings)
    linear = message.twist.twist.linear
    speed = math.hypot(float(linear.x), float(linear.y), float(linear.z))
    if settings["speed"] and math.isfinite(speed):
        (x, y, z), _ = pose_of(message.pose.pose)
        label = Text(shown_text(f"{speed:.2f} m/s", MAX_SPEED), 0.15)
        header = message.header
        shapes.append(Placed(label, header.frame_id, stamp_of(header), (x, y, z + 0.3)))
    return shapes


def shapes_of_pose_array(message: Any, settings: Values) -> list[Placed]:
    """Return the poses of a `geometry_msgs/msg/PoseArray`; those with numbers that are not finite are left out."""
    return _placed_poses(message.poses, message.header, settings)


def _placed_poses(poses: Any, header: Any, settings: Values) -> list[Placed]:
    positions, rotations = [], []
    for pose in poses[:MAX_POSES]:
        try:
            position, rotation = pose_of(pose)
        except DisplayError:
            continue
        positions.append(position)
        rotations.append(rotation)
    if not positions:
        return []
    return [
        Placed(shape, header.frame_id, stamp_of(header)) for shape in _marks(positions, rotations, settings)
    ]


def shapes_of_point(message: Any, settings: Values) -> list[Placed]:
    """Return the ball of a `geometry_msgs/msg/PointStamped`."""
    points = finite_points([message.point])
    ball = Ball((settings["radius"],) * 3, settings["color"], settings["opacity"])
    return [
        Placed(ball, message.header.frame_id, stamp_of(message.header), (float(x), float(y), float(z)))
        for x, y, z in points
    ]


def line_strip(points: Any) -> Any:
    """Return the lines between neighbouring points (N - 1, 2, 3)."""
    return np.stack([points[:-1], points[1:]], axis=1)


def shapes_of_path(message: Any, settings: Values) -> list[Placed]:
    """Return the line of a `nav_msgs/msg/Path`, and its poses if they are wanted.

    The poses' own headers are not read, as RViz doesn't: they are in the frame of the path.
    """
    step = -(-len(message.poses) // MAX_POINTS) or 1
    points = finite_points([stamped.pose.position for stamped in message.poses[::step]])
    if len(points) < 2:
        return []
    width = settings["width"] if settings["line"] == "wide" else None
    line = line_shape(line_strip(points), settings["color"], settings["opacity"], width)
    marks = {
        "shape": "axes" if settings["poses"] == "axes" else "arrow",
        "color": settings["pose_color"],
        **{
            name: settings[name]
            for name in ("opacity", "axes_length", "axes_radius", "shaft_length", "head_length")
        },
        "shaft_radius": settings["shaft_diameter"] / 2.0,
        "head_radius": settings["head_diameter"] / 2.0,
    }
    poses = [stamped.pose for stamped in message.poses] if settings["poses"] != "none" else []
    return [
        Placed(line, message.header.frame_id, stamp_of(message.header)),
        *_placed_poses(poses, message.header, marks),
    ]


def shapes_of_polygon(message: Any, settings: Values) -> list[Placed]:
    """Return the closed line of a `geometry_msgs/msg/PolygonStamped`."""
    points = finite_points(message.polygon.points[:MAX_POINTS])
    if len(points) < 2:
        return []
    ends = line_strip(np.concatenate([points, points[:1]]))
    line = line_shape(ends, settings["color"], settings["opacity"])
    return [Placed(line, message.header.frame_id, stamp_of(message.header))]
