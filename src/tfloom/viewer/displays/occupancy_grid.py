"""Occupancy grids, as pictures on the floor, and cells."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.viewer.displays.display import finite_points, pose_of, stamp_of
from tfloom.viewer.shapes import DisplayError, Mesh, Picture, Placed

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

__all__ = ["shapes_of_cells", "shapes_of_grid"]

MAX_SIDE = 4096
"""Number of cells along a side that are drawn; of more, every second one is, or every third."""
MAX_CELLS = 50_000
"""Number of cells that are drawn one by one."""
MAX_CELL_M = 1e6
UNKNOWN = (112, 137, 134, 160)
"""Colour and opacity of a cell of -1."""
INVALID = (200, 40, 200, 255)
"""… and of a cell that is neither -1 nor from 0 to 100."""


def shapes_of_grid(message: Any, settings: Values) -> list[Placed]:
    """Return the picture of a `nav_msgs/msg/OccupancyGrid`: free cells are light, occupied ones dark.

    Raises:
        DisplayError: its sizes or its origin are wrong.
    """
    width, height = int(message.info.width), int(message.info.height)
    resolution = float(message.info.resolution)
    cells = np.asarray(message.data, np.int8)
    if not width * height:
        return []
    if len(cells) != width * height:
        raise DisplayError(
            f"its data has {len(cells)} cells, and {width} by {height} require {width * height}"
        )
    if not (math.isfinite(resolution) and resolution > 0.0):
        raise DisplayError(f"its resolution is {resolution:g} m, and has to be above zero")
    step = -(-max(width, height) // MAX_SIDE)
    # The grid's first row is its lowest one, a picture's its uppermost.
    rows = cells.reshape(height, width)[::step, ::step][::-1]
    position, rotation = pose_of(message.info.origin)
    picture = Picture(_colors(rows, settings), (width * resolution, height * resolution))
    return [Placed(picture, message.header.frame_id, stamp_of(message.header), position, rotation)]


def _colors(cells: Any, settings: Values) -> Any:
    values = np.arange(256).astype(np.uint8).view(np.int8).astype(np.int32)
    if settings["binary"]:
        values = np.where(
            (values >= 0) & (values <= 100), np.where(values >= settings["threshold"], 100, 0), values
        )
    table = _TABLES[settings["colors"]](values)
    table[:, 3] = np.round(table[:, 3] * settings["opacity"])
    return table.astype(np.uint8)[cells.view(np.uint8)]


def _map_table(values: Any) -> Any:
    """Return colour and opacity of each value (256, 4): free cells are light, occupied ones dark."""
    table = np.tile(np.array(INVALID, np.float64), (256, 1))
    known = (values >= 0) & (values <= 100)
    light = 254 - (values[known] * 254) // 100
    table[known] = np.stack([light, light, light, np.full(len(light), 255)], axis=1)
    table[values == -1] = UNKNOWN
    return table


def _costmap_table(values: Any) -> Any:
    """Return colour and opacity of each value (256, 4): costs from blue to red, free cells clear."""
    table = _map_table(values)
    cost = (values > 0) & (values < 99)
    red = 255 * values[cost] // 100
    table[cost] = np.stack([red, np.zeros(len(red)), 255 - red, np.full(len(red), 255)], axis=1)
    table[values == 0] = (0, 0, 0, 0)
    table[values == 99] = (0, 255, 255, 255)
    table[values == 100] = (255, 0, 255, 255)
    return table


def _raw_table(values: Any) -> Any:
    """Return the number of each value as its brightness (256, 4)."""
    light = np.where(values < 0, values + 256, values).astype(np.float64)
    return np.stack([light, light, light, np.full(256, 255.0)], axis=1)


_TABLES = {"map": _map_table, "costmap": _costmap_table, "raw": _raw_table}


def shapes_of_cells(message: Any, settings: Values) -> list[Placed]:
    """Return the cells of a `nav_msgs/msg/GridCells`, as squares.

    Raises:
        DisplayError: its sizes are wrong.
    """
    width, height = float(message.cell_width), float(message.cell_height)
    if not (0.0 < width < MAX_CELL_M and 0.0 < height < MAX_CELL_M):
        raise DisplayError(f"its cells are {width:g} m by {height:g} m, and have to be above zero")
    step = -(-len(message.cells) // MAX_CELLS) or 1
    centres = finite_points(message.cells[::step])
    if not len(centres):
        return []
    corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) * (width / 2.0, height / 2.0, 0.0)
    vertices = (centres[:, np.newaxis] + corners).astype(np.float32).reshape(-1, 3)
    first = 4 * np.arange(len(centres))[:, np.newaxis, np.newaxis]
    faces = (first + np.array([(0, 1, 2), (0, 2, 3)])).reshape(-1, 3).astype(np.uint32)
    squares = Mesh(vertices, faces, settings["color"], settings["opacity"])
    return [Placed(squares, message.header.frame_id, stamp_of(message.header))]
