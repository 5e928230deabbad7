"""A force and a torque: an arrow each, and a ring around the torque's that shows the way it turns."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from tfloom.viewer.displays.display import MAX_COORDINATE_M, Latest, stamp_of
from tfloom.viewer.shapes import Color, DisplayError, Mesh, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Value

__all__ = ["WrenchDisplay"]

SIDES = 10
"""Number of the sides of a shaft."""
SHAFT = 0.05
HEAD = 0.1
RING = 0.025
"""Radii of a shaft, a head and a ring, for a width of 1 [m]."""
HEAD_LENGTH = 0.3
"""Length of a head, for a shaft of 1 m [m]."""
RING_HEAD_LENGTH = 0.1
"""Length of the head of a ring, for a width of 1 [m]."""
RING_ANGLES_RAD = np.linspace(0.25 * math.pi, 2.0 * math.pi, 29)
"""Where the ring's parts begin: an eighth of it is open, so that its head is seen [rad]."""


class WrenchDisplay(Latest):
    """Shows the last ones of `geometry_msgs/msg/WrenchStamped`, as RViz does.

    Args:
        settings: A value for each setting.
    """

    def __init__(self, settings: Mapping[str, Value]) -> None:
        super().__init__(self._shapes_of_wrench)
        self._settings = settings

    def take(self, message: Any, stamp_ns: int) -> None:
        """Take the next message.

        Raises:
            DisplayError: it has a number that can't be drawn, or nothing that is long enough.
        """
        self._shapes = [*self._shapes_of_wrench(message), *self._shapes]

    def _shapes_of_wrench(self, message: Any) -> list[Placed]:
        wrench, width = message.wrench, self._number("width")
        force = _vector(wrench.force, self._number("force_scale"), "force")
        torque = _vector(wrench.torque, self._number("torque_scale"), "torque")
        meshes = []
        if force.length > width:
            meshes.append(self._mesh([_arrow(force, width)], "force_color"))
        if torque.length > width:
            meshes.append(self._mesh([_arrow(torque, width), _ring(torque, width)], "torque_color"))
        if not meshes:
            raise DisplayError(f"its arrows would be shorter than their width of {width:g}")
        return [Placed(mesh, message.header.frame_id, stamp_of(message.header)) for mesh in meshes]

    def _number(self, name: str) -> float:
        return cast("float", self._settings[name])

    def _mesh(self, tubes: list[NDArray[np.float64]], color: str) -> Mesh:
        vertices = np.concatenate([tube.reshape(-1, 3) for tube in tubes]).astype(np.float32)
        starts = np.cumsum([0, *(tube[..., 0].size for tube in tubes)])
        faces = [_faces(len(tube)) + start for tube, start in zip(tubes, starts[:-1], strict=True)]
        return Mesh(
            vertices,
            np.concatenate(faces).astype(np.uint32),
            cast("Color", self._settings[color]),
            self._number("opacity"),
        )


class _Vector(NamedTuple):
    """A vector as it is drawn."""

    length: float
    """[m]."""
    axes: NDArray[np.float64]
    """Its direction, last, and two directions across it, right-handed (3, 3)."""


def _vector(vector: Any, scale: float, name: str) -> _Vector:
    """Return a force or a torque as it is drawn.

    Raises:
        DisplayError: it is not finite, or too long.
    """
    parts = np.array((vector.x, vector.y, vector.z), np.float64)
    greatest = float(np.abs(parts).max())
    # The greatest part first, because the square of a large one is beyond what a number holds, and that of a small one
    # is zero.
    parts = parts / greatest if 0.0 < greatest < math.inf else parts
    size = greatest * float(np.linalg.norm(parts))
    length = size * scale
    if not (1.0 + HEAD_LENGTH) * length < MAX_COORDINATE_M:
        raise DisplayError(f"its {name} is not finite, or its arrow is longer than {MAX_COORDINATE_M:g} m")
    if not length > 0.0:
        return _Vector(0.0, np.eye(3))
    return _Vector(length, _axes_along(parts / np.linalg.norm(parts)))


def _axes_along(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return x, y and z after the least turn that brings z to a direction; half a turn is around y."""
    x, y, z = direction
    if z < -1.0 + 1e-9:
        return np.diag((-1.0, 1.0, -1.0))
    part = 1.0 / (1.0 + z)
    return np.array(
        [(1.0 - x * x * part, -x * y * part, -x), (-x * y * part, 1.0 - y * y * part, -y), (x, y, z)]
    )


def _arrow(vector: _Vector, width: float) -> NDArray[np.float64]:
    """Return the tube of an arrow: RViz's shaft is as long as the vector, and its head comes after it."""
    heights = vector.length * np.array((0.0, 0.0, 1.0, 1.0, 1.0 + HEAD_LENGTH))
    radii = width * np.array((0.0, SHAFT, SHAFT, HEAD, 0.0))
    across, beside, along = vector.axes
    return _tube(heights[:, np.newaxis] * along, np.tile(across, (5, 1)), np.tile(beside, (5, 1)), radii)


def _ring(vector: _Vector, width: float) -> NDArray[np.float64]:
    """Return the tube of the ring at half an arrow, around it by the right-hand rule, and its head."""
    angles = RING_ANGLES_RAD[:, np.newaxis]
    across, beside, along = vector.axes
    outwards = np.cos(angles) * across + np.sin(angles) * beside
    centres = vector.length / 2.0 * along + vector.length / 4.0 * outwards
    tip = centres[-1] + RING_HEAD_LENGTH * width * beside
    centres = np.vstack([centres[0], centres, centres[-1], tip])
    outwards = np.vstack([outwards[0], outwards, outwards[-1], outwards[-1]])
    radii = width * np.array((0.0, *([RING] * len(RING_ANGLES_RAD)), HEAD, 0.0))
    return _tube(centres, outwards, np.tile(along, (len(centres), 1)), radii)


def _tube(
    centres: NDArray[np.float64],
    firsts: NDArray[np.float64],
    seconds: NDArray[np.float64],
    radii: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return the rims of a tube (N, SIDES, 3), by the centre, two directions and the radius of each."""
    angles = np.arange(SIDES)[:, np.newaxis] * (2.0 * math.pi / SIDES)
    spokes = np.cos(angles) * firsts[:, np.newaxis] + np.sin(angles) * seconds[:, np.newaxis]
    rims: NDArray[np.float64] = centres[:, np.newaxis] + radii[:, np.newaxis, np.newaxis] * spokes
    return rims


def _faces(rims: int) -> NDArray[np.int64]:
    """Return the triangles between neighbouring rims of a tube (M, 3)."""
    rim, side = np.meshgrid(np.arange(rims - 1) * SIDES, np.arange(SIDES), indexing="ij")
    low, low_next = rim + side, rim + (side + 1) % SIDES
    corners = np.stack([low, low_next, low + SIDES, low_next, low_next + SIDES, low + SIDES], axis=-1)
    triangles: NDArray[np.int64] = corners.reshape(-1, 3)
    return triangles
