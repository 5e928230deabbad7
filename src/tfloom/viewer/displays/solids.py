"""Arrows, axes and lines as triangles, which may be transparent as viser's own are not."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.shapes import Axes, Color, Lines, Mesh, Shape

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["SIDES", "ArrowSizes", "arrow_mesh", "axes_shapes", "line_shape", "merged", "tube", "tube_faces"]

SIDES = 10
"""Number of the sides of a shaft."""
THIN_M = 0.01
"""Thickness of a line of no thickness that is transparent [m]."""
MAX_SOLID_LINES = 20_000
"""Number of lines up to which they may be transparent."""
RED: Color = (255, 0, 0)
GREEN: Color = (0, 255, 0)
BLUE: Color = (0, 0, 255)


class ArrowSizes(NamedTuple):
    """Sizes of an arrow [m]."""

    shaft_length: float
    shaft_radius: float
    head_length: float
    head_radius: float


def arrow_mesh(
    positions: ArrayLike, rotations_xyzw: ArrayLike, sizes: ArrowSizes, color: Color, opacity: float
) -> Mesh:
    """Return an arrow along the x axis of each of many poses: positions (N, 3) [m], unit quaternions (N, 4)."""
    end = sizes.shaft_length + sizes.head_length
    heights = np.array((0.0, 0.0, sizes.shaft_length, sizes.shaft_length, end))
    radii = np.array((0.0, sizes.shaft_radius, sizes.shaft_radius, sizes.head_radius, 0.0))
    return _copied(_straight(heights, radii), positions, rotations_xyzw, color, opacity)


def axes_shapes(
    positions: ArrayLike, rotations_xyzw: ArrayLike, length: float, radius: float, opacity: float
) -> list[Shape]:
    """Return the three axes of each of many poses: positions (N, 3) [m], unit quaternions (N, 4)."""
    if opacity >= 1.0:
        places, turns = np.array(positions, np.float32), np.array(rotations_xyzw, np.float32)
        return [Axes(places, turns, length, radius)]
    heights, radii = np.array((0.0, 0.0, length, length)), np.array((0.0, radius, radius, 0.0))
    along_x = _straight(heights, radii)
    return [
        _copied(np.roll(along_x, shift, axis=-1), positions, rotations_xyzw, color, opacity)
        for shift, color in enumerate((RED, GREEN, BLUE))
    ]


def line_shape(
    ends: NDArray[np.float32], color: Color, opacity: float, width_m: float | None = None
) -> Shape:
    """Return straight lines (N, 2, 3) [m]; without a width they are as thin on each page as lines are."""
    if opacity >= 1.0 or len(ends) > MAX_SOLID_LINES:
        return Lines(ends, np.array(color, np.uint8), width_m=width_m)
    starts, vectors = ends[:, 0].astype(np.float64), np.diff(ends, axis=1)[:, 0].astype(np.float64)
    lengths = np.linalg.norm(vectors, axis=1)
    directions = np.tile((1.0, 0.0, 0.0), (len(ends), 1))
    has_length = lengths > 0.0
    directions[has_length] = vectors[has_length] / lengths[has_length, np.newaxis]
    # Any direction across: the axis to which the line is the least parallel gives one.
    others = np.eye(3)[np.abs(directions).argmin(axis=1)]
    across = np.cross(directions, others)
    across /= np.linalg.norm(across, axis=1)[:, np.newaxis]
    beside = np.cross(directions, across)
    angles = np.arange(4) * (0.5 * math.pi)
    spokes = (
        (width_m or THIN_M)
        / 2.0
        * (
            np.cos(angles)[:, np.newaxis] * across[:, np.newaxis]
            + np.sin(angles)[:, np.newaxis] * beside[:, np.newaxis]
        )
    )
    rims = np.stack([starts[:, np.newaxis] + spokes, (starts + vectors)[:, np.newaxis] + spokes], axis=1)
    faces = tube_faces(2, 4)
    return Mesh(
        rims.reshape(-1, 3).astype(np.float32),
        (faces[np.newaxis] + 8 * np.arange(len(ends))[:, np.newaxis, np.newaxis])
        .reshape(-1, 3)
        .astype(np.uint32),
        color,
        opacity,
    )


def merged(tubes: list[NDArray[np.float64]], color: Color, opacity: float) -> Mesh:
    """Return tubes as one mesh; each is its rims (R, SIDES, 3) [m]."""
    vertices = np.concatenate([part.reshape(-1, 3) for part in tubes]).astype(np.float32)
    starts = np.cumsum([0, *(part[..., 0].size for part in tubes)])
    faces = [tube_faces(len(part)) + start for part, start in zip(tubes, starts[:-1], strict=True)]
    return Mesh(vertices, np.concatenate(faces).astype(np.uint32), color, opacity)


def _straight(heights: NDArray[np.float64], radii: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rims of a tube along x."""
    count = len(heights)
    centres = heights[:, np.newaxis] * np.array((1.0, 0.0, 0.0))
    y, z = np.tile((0.0, 1.0, 0.0), (count, 1)), np.tile((0.0, 0.0, 1.0), (count, 1))
    return tube(centres, y, z, radii)


def _copied(
    rims: NDArray[np.float64], positions: ArrayLike, rotations_xyzw: ArrayLike, color: Color, opacity: float
) -> Mesh:
    points = rims.reshape(-1, 3)
    places, turns = np.asarray(positions, np.float64), np.asarray(rotations_xyzw, np.float64)
    axis, w = turns[:, np.newaxis, :3], turns[:, np.newaxis, 3:]
    cross = 2.0 * np.cross(axis, points[np.newaxis])
    moved: Any = places[:, np.newaxis] + points + w * cross + np.cross(axis, cross)
    faces = (
        tube_faces(len(rims))[np.newaxis] + len(points) * np.arange(len(places))[:, np.newaxis, np.newaxis]
    )
    return Mesh(
        moved.reshape(-1, 3).astype(np.float32), faces.reshape(-1, 3).astype(np.uint32), color, opacity
    )


def tube(
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


def tube_faces(rims: int, sides: int = SIDES) -> NDArray[np.int64]:
    """Return the triangles between neighbouring rims of a tube (M, 3)."""
    rim, side = np.meshgrid(np.arange(rims - 1) * sides, np.arange(sides), indexing="ij")
    low, low_next = rim + side, rim + (side + 1) % sides
    corners = np.stack([low, low_next, low + sides, low_next, low_next + sides, low + sides], axis=-1)
    triangles: NDArray[np.int64] = corners.reshape(-1, 3)
    return triangles
