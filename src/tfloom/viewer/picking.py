"""What a place on the screen shows: the nearest frame or shape that the ray from the camera meets."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.viewer import shapes
from tfloom.viewer.camera import Camera, direction_of, projected
from tfloom.viewer.extents import corners_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.frames import FramePoses

__all__ = ["Met", "frame_at", "nearest_shape"]

REACH_PX = 10.0
"""How far from a frame's origin, a point or a line a click still meets it, on the screen [pixels]."""
STEP_PX = 3.0
"""Origins that are apart by less are at one place of the screen [pixels]."""
FLAT_M = 1e-4
"""Half of the thickness that something flat has for a ray [m]."""


class Met(NamedTuple):
    """A shape that a ray meets."""

    display: str
    number: int
    """Its number among the shapes of the display."""
    point: tuple[float, float, float]
    """Where it is met, in the fixed frame [m]."""
    distance_m: float
    """From the camera."""


class _Ray(NamedTuple):
    start: NDArray[np.float64]
    """(3,) [m]."""
    direction: NDArray[np.float64]
    """(3,), of length 1."""
    reach: float
    """How far beside it a thing of no size is met, by its distance."""


def frame_at(
    camera: Camera,
    across: float,
    down: float,
    poses: FramePoses,
    height_px: float,
    reach_px: float = REACH_PX,
) -> str | None:
    """Return the frame whose origin is nearest to a place on the screen, and then to the camera; None without any.

    Args:
        camera: The camera.
        across: From 0 at the left edge to 1 at the right edge.
        down: From 0 at the upper edge to 1 at the lower edge.
        poses: The frames.
        height_px: Height of the picture [pixels].
        reach_px: How far from the place an origin may be [pixels].
    """
    if not poses.names:
        return None
    seen = projected(camera, poses.positions)
    apart_px = np.hypot((seen[:, 0] - across) * camera.aspect, seen[:, 1] - down) * height_px
    within = np.flatnonzero(apart_px <= reach_px)  # one behind the camera is nowhere: NaN
    if not len(within):
        return None
    steps = apart_px[within] // STEP_PX
    return poses.names[int(within[np.lexsort((seen[within, 2], steps))[0]])]


def nearest_shape(
    camera: Camera,
    across: float,
    down: float,
    drawn: Mapping[str, Iterable[tuple[shapes.Shape, Pose | None]]],
    height_px: float,
) -> Met | None:
    """Return the shape that a place on the screen shows; None where there is none.

    Meshes of files are met where the box around them is.

    Args:
        camera: The camera.
        across: From 0 at the left edge to 1 at the right edge.
        down: From 0 at the upper edge to 1 at the lower edge.
        drawn: The shapes of each display with their poses in the fixed frame; those without one are hidden.
        height_px: Height of the picture [pixels].
    """
    direction = np.array(direction_of(camera, across, down))
    # Angles near the middle of the picture are a little more than what they are at its edges.
    reach = REACH_PX / height_px * 2.0 * np.tan(camera.fov_rad / 2.0)
    ray = _Ray(np.array(camera.position), direction / np.linalg.norm(direction), float(reach))
    best: Met | None = None
    for display, parts in drawn.items():
        for index, (shape, pose) in enumerate(parts):
            if pose is None:
                continue
            distance_m = _distance(ray, shape, pose)
            if np.isfinite(distance_m) and (best is None or distance_m < best.distance_m):
                x, y, z = (ray.start + distance_m * ray.direction).tolist()
                best = Met(display, index, (x, y, z), distance_m)
    return best


def _distance(ray: _Ray, shape: shapes.Shape, pose: Pose) -> float:
    """Return how far along a ray a shape is met [m]; infinity where it isn't."""
    local_from_fixed = Transform(*pose).inverse()
    start, end = (
        np.array(local_from_fixed.apply(tuple(point.tolist())))
        for point in (ray.start, ray.start + ray.direction)
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        found = _MEET[type(shape)](_Ray(start, end - start, ray.reach), shape)
    found = np.atleast_1d(found)
    found = found[np.isfinite(found) & (found > 0.0)]
    return float(found.min()) if len(found) else np.inf


def _of_points(ray: _Ray, points: Any) -> NDArray[np.float64]:
    to_points = np.asarray(points, np.float64).reshape(-1, 3) - ray.start
    along = to_points @ ray.direction
    beside = np.linalg.norm(to_points - along[:, np.newaxis] * ray.direction, axis=1)
    return np.where(beside <= ray.reach * along, along, np.inf)


def _of_lines(ray: _Ray, ends: Any) -> NDArray[np.float64]:
    """Return where a ray passes segments: at the place of each that is nearest to it."""
    table = np.asarray(ends, np.float64).reshape(-1, 2, 3)
    starts, ways = table[:, 0], table[:, 1] - table[:, 0]
    # Across the ray, a segment is a line in a plane, and the ray is the origin.
    flat_starts, flat_ways = (
        part - (part @ ray.direction)[:, np.newaxis] * ray.direction for part in (starts - ray.start, ways)
    )
    lengths = (flat_ways**2).sum(axis=1)
    parts = np.clip(-(flat_starts * flat_ways).sum(axis=1) / np.where(lengths > 0.0, lengths, 1.0), 0.0, 1.0)
    return _of_points(ray, starts + parts[:, np.newaxis] * ways)


def _of_boxes(ray: _Ray, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where a ray enters boxes along the axes, (N, 3) or (3,); from within one, where it leaves it."""
    first, second = (low - FLAT_M - ray.start) / ray.direction, (high + FLAT_M - ray.start) / ray.direction
    entry, leave = np.fmin(first, second).max(axis=-1), np.fmax(first, second).min(axis=-1)
    return np.where(entry <= leave, np.where(entry > 0.0, entry, leave), np.inf)


def _of_box(ray: _Ray, shape: shapes.Box) -> NDArray[np.float64]:
    half = np.array(shape.size) / 2.0
    return _of_boxes(ray, -half, half)


def _of_copies(ray: _Ray, shape: shapes.Copies) -> NDArray[np.float64]:
    centres, half = np.asarray(shape.positions, np.float64), np.array(shape.size) / 2.0
    return _of_boxes(ray, centres - half, centres + half)


def _roots(a: float, b: float, c: float) -> NDArray[np.float64]:
    """Return the solutions of a x² + 2 b x + c = 0; NaN where there are none."""
    root = np.sqrt(np.float64(b * b - a * c))
    roots: NDArray[np.float64] = np.array([-b - root, -b + root]) / np.float64(a)
    return roots


def _of_ball(ray: _Ray, shape: shapes.Ball) -> NDArray[np.float64]:
    start, way = ray.start / np.array(shape.radii), ray.direction / np.array(shape.radii)
    return _roots(float(way @ way), float(start @ way), float(start @ start) - 1.0)


def _of_cylinder(ray: _Ray, shape: shapes.Cylinder) -> NDArray[np.float64]:
    half = shape.height_m / 2.0
    start, way = ray.start[:2], ray.direction[:2]
    sides = _roots(float(way @ way), float(start @ way), float(start @ start) - shape.radius_m**2)
    sides = np.where(np.abs(ray.start[2] + sides * ray.direction[2]) <= half, sides, np.inf)
    ends = (np.array((-half, half)) - ray.start[2]) / ray.direction[2]
    places = start + ends[:, np.newaxis] * way
    return np.concatenate([sides, np.where(np.linalg.norm(places, axis=1) <= shape.radius_m, ends, np.inf)])


def _of_mesh(ray: _Ray, shape: shapes.Mesh) -> NDArray[np.float64]:
    """Return where a ray meets each triangle of a mesh, by the way of Möller and Trumbore."""
    corners = np.asarray(shape.vertices, np.float64)[shape.faces]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(ray.direction, second)
    volume = (first * across).sum(axis=1)
    start = ray.start - corners[:, 0]
    u = (start * across).sum(axis=1) / volume
    around = np.cross(start, first)
    v = around @ ray.direction / volume
    return np.where((u >= 0.0) & (v >= 0.0) & (u + v <= 1.0), (second * around).sum(axis=1) / volume, np.inf)


def _of_corners(ray: _Ray, shape: shapes.Shape) -> NDArray[np.float64]:
    corners = corners_of(shape)
    if corners is None:
        return np.empty(0)
    return _of_boxes(ray, corners.min(axis=0), corners.max(axis=0))


_MEET: dict[type[shapes.Shape], Callable[[_Ray, Any], NDArray[np.float64]]] = {
    shapes.Points: lambda ray, shape: _of_points(ray, shape.positions),
    shapes.Lines: lambda ray, shape: _of_lines(ray, shape.ends),
    shapes.Arrows: lambda ray, shape: _of_lines(ray, shape.ends),
    shapes.Axes: lambda ray, shape: _of_points(ray, shape.positions),
    shapes.Mesh: _of_mesh,
    shapes.Box: _of_box,
    shapes.Ball: _of_ball,
    shapes.Cylinder: _of_cylinder,
    shapes.Copies: _of_copies,
    shapes.Text: lambda ray, _: _of_points(ray, np.zeros((1, 3))),
    shapes.Picture: _of_corners,
    shapes.Model: _of_corners,
}
