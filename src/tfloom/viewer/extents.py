"""How far shapes reach, and from where a camera sees all of that."""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.viewer import shapes
from tfloom.viewer.displays.display import MAX_COORDINATE_M
from tfloom.viewer.layout.layout import ViewPoint

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.drawing import Pose

__all__ = ["Extent", "corners_of", "extent_of", "view_of"]

MAX_NODES = 10_000
"""Number of nodes of a file of glTF that are looked at."""
MIN_RADIUS_M = 0.05
"""Less than this is looked at from as far as this."""
MARGIN = 1.1
"""How much further away the camera is than it has to be."""
DIRECTION = (-3.0, -4.0, 3.0)
"""From what is looked at to the camera, where that has none of its own."""
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float64)


class Extent(NamedTuple):
    """A box along the axes of the fixed frame."""

    low: NDArray[np.float64]
    """The corner of the least coordinates (3,) [m]."""
    high: NDArray[np.float64]

    @property
    def radius_m(self) -> float:
        """The radius of the ball around it [m]."""
        return float(np.linalg.norm(self.high - self.low)) / 2.0


def extent_of(
    points: NDArray[np.float64], drawn: Iterable[tuple[shapes.Shape, Pose | None]]
) -> Extent | None:
    """Return the box around points and shapes; None without any.

    Args:
        points: (N, 3) in the fixed frame [m].
        drawn: The shapes with their poses in the fixed frame; those without one are not looked at.
    """
    parts = [points]
    for shape, pose in drawn:
        if pose is not None and (corners := corners_of(shape)) is not None:
            moved = Transform(*pose)
            parts.append(np.array([moved.apply(corner) for corner in corners.tolist()]))
    together = np.concatenate(parts)
    together = together[(np.abs(together) < MAX_COORDINATE_M).all(axis=1)]
    if not len(together):
        return None
    return Extent(together.min(axis=0), together.max(axis=0))


def view_of(
    extent: Extent, fov_rad: float, aspect: float, direction: Sequence[float] = DIRECTION
) -> ViewPoint:
    """Return from where a camera sees an extent whole.

    Args:
        extent: What is looked at.
        fov_rad: The camera's vertical field of view.
        aspect: Width by height of its picture.
        direction: From what is looked at to the camera; the usual one if it has no length.
    """
    toward = np.array(direction, np.float64)
    if not np.linalg.norm(toward) > 0.0:
        toward = np.array(DIRECTION)
    half_rad = min(fov_rad / 2.0, math.atan(math.tan(fov_rad / 2.0) * aspect))
    distance_m = MARGIN * max(extent.radius_m, MIN_RADIUS_M) / math.sin(half_rad)
    middle = (extent.low + extent.high) / 2.0
    x, y, z = (middle + toward / np.linalg.norm(toward) * distance_m).tolist()
    at_x, at_y, at_z = middle.tolist()
    return ViewPoint((x, y, z), (at_x, at_y, at_z))


def corners_of(shape: shapes.Shape) -> NDArray[np.float64] | None:
    """Return points around a shape in its own frame (N, 3) [m]; None without any."""
    points = _POINTS[type(shape)](shape)
    if points is None or not len(points):
        return None
    table = np.asarray(points, np.float64).reshape(-1, 3)
    table = table[np.isfinite(table).all(axis=1)]
    return _box(table.min(axis=0), table.max(axis=0)) if len(table) else None


def _box(low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
    return low + _CORNERS * (high - low)


def _around(half: Sequence[float]) -> NDArray[np.float64]:
    reach = np.array(half, np.float64)
    return np.array([-reach, reach])


def _points_of_copies(copies: shapes.Copies) -> NDArray[np.float64]:
    centres = np.asarray(copies.positions, np.float64)
    half = np.array(copies.size) / 2.0
    return np.concatenate([centres - half, centres + half])


def _points_of_model(model: shapes.Model) -> NDArray[np.float64] | None:
    """Return the corners of what a file of glTF has, by what it says of its vertices; None if it says nothing."""
    try:
        length = int.from_bytes(model.glb[12:16], "little")
        content = json.loads(model.glb[20 : 20 + length])
        parts = list(itertools.islice(_meshes(content), MAX_NODES))
    except (ValueError, LookupError, TypeError, AttributeError, ArithmeticError, RecursionError):
        return None
    return np.concatenate(parts) * model.scale if parts else None


def _meshes(content: Any) -> Iterable[NDArray[np.float64]]:
    """Yield the corners of each mesh of a scene of glTF.

    Raises:
        ValueError, LookupError, TypeError, AttributeError, ArithmeticError, RecursionError: it is not glTF.
    """
    nodes = content["nodes"]
    roots = content["scenes"][content.get("scene", 0)]["nodes"]
    waiting = [(root, np.eye(4)) for root in roots[:MAX_NODES]]
    for _ in range(MAX_NODES):
        if not waiting:
            return
        number, parent = waiting.pop()
        node = nodes[number]
        matrix = parent @ _matrix(node)
        waiting += [(child, matrix) for child in node.get("children", [])[: MAX_NODES - len(waiting)]]
        for primitive in content["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            accessor = content["accessors"][primitive["attributes"]["POSITION"]]
            corners = _box(np.array(accessor["min"], np.float64), np.array(accessor["max"], np.float64))
            yield corners @ matrix[:3, :3].T + matrix[:3, 3]


def _matrix(node: Any) -> NDArray[np.float64]:
    """Return parent_from_node of a node of glTF (4, 4)."""
    if "matrix" in node:
        given: NDArray[np.float64] = np.array(node["matrix"], np.float64).reshape(4, 4).T
        return given
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    turned = Transform(rotation_xyzw=(x, y, z, w))
    axes = [turned.apply(axis) for axis in np.eye(3).tolist()]
    matrix[:3, :3] = np.array(axes).T * np.array(node.get("scale", (1.0, 1.0, 1.0)), np.float64)
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


_POINTS: dict[type[shapes.Shape], Callable[[Any], Any]] = {
    shapes.Points: lambda shape: shape.positions,
    shapes.Lines: lambda shape: shape.ends,
    shapes.Arrows: lambda shape: shape.ends,
    shapes.Axes: lambda shape: shape.positions,
    shapes.Mesh: lambda shape: shape.vertices,
    shapes.Box: lambda shape: _around([part / 2.0 for part in shape.size]),
    shapes.Ball: lambda shape: _around(shape.radii),
    shapes.Cylinder: lambda shape: _around([shape.radius_m, shape.radius_m, shape.height_m / 2.0]),
    shapes.Copies: _points_of_copies,
    shapes.Text: lambda _: np.zeros((1, 3)),
    shapes.Picture: lambda shape: np.array([(0.0, 0.0, 0.0), (*shape.size, 0.0)]),
    shapes.Model: _points_of_model,
}
