"""Wrenches and twists: an arrow for each vector, and a ring around that of the one that turns, which shows the way."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.displays.display import MAX_COORDINATE_M, stamp_of
from tfloom.viewer.displays.solids import merged, tube
from tfloom.viewer.shapes import DisplayError, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values

__all__ = ["shapes_of_twist", "shapes_of_wrench"]

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


class TwinArrows(NamedTuple):
    """Names of the settings for two vectors, of which the second is what turns."""

    names: tuple[str, str]
    colors: tuple[str, str]
    scales: tuple[str, str]


WRENCH = TwinArrows(("force", "torque"), ("force_color", "torque_color"), ("force_scale", "torque_scale"))
TWIST = TwinArrows(
    ("linear", "angular"), ("linear_color", "angular_color"), ("linear_scale", "angular_scale")
)


def shapes_of_wrench(message: Any, settings: Values) -> list[Placed]:
    """Return the arrows of a `geometry_msgs/msg/WrenchStamped`, as RViz does.

    Raises:
        DisplayError: it has a number that can't be drawn, or nothing that is long enough.
    """
    return _shapes(message.header, (message.wrench.force, message.wrench.torque), WRENCH, settings)


def shapes_of_twist(message: Any, settings: Values) -> list[Placed]:
    """Return the arrows of a `geometry_msgs/msg/TwistStamped`, as RViz does.

    Raises:
        DisplayError: it has a number that can't be drawn, or nothing that is long enough.
    """
    return _shapes(message.header, (message.twist.linear, message.twist.angular), TWIST, settings)


def _shapes(header: Any, vectors: tuple[Any, Any], twins: TwinArrows, settings: Values) -> list[Placed]:
    width, opacity = settings["width"], settings["opacity"]
    straight, turning = (
        _vector(vector, settings[scale], name)
        for vector, scale, name in zip(vectors, twins.scales, twins.names, strict=True)
    )
    meshes = []
    if straight.length > width:
        meshes.append(merged([_arrow(straight, width)], settings[twins.colors[0]], opacity))
    if turning.length > width:
        tubes = [_arrow(turning, width), _ring(turning, width)]
        meshes.append(merged(tubes, settings[twins.colors[1]], opacity))
    if not meshes:
        raise DisplayError(f"its arrows would be shorter than their width of {width:g}")
    return [Placed(mesh, header.frame_id, stamp_of(header)) for mesh in meshes]


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
    return tube(heights[:, np.newaxis] * along, np.tile(across, (5, 1)), np.tile(beside, (5, 1)), radii)


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
    return tube(centres, outwards, np.tile(along, (len(centres), 1)), radii)
