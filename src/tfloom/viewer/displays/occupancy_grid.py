"""Occupancy grids, as pictures on the floor."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tfloom.viewer.displays.display import pose_of, stamp_of
from tfloom.viewer.shapes import DisplayError, Picture, Placed

__all__ = ["shapes_of_grid"]

MAX_SIDE = 4096
"""Number of cells along a side that are drawn; of more, every second one is, or every third."""
UNKNOWN = (112, 137, 134, 160)
"""Colour and opacity of a cell of -1."""
INVALID = (200, 40, 200, 255)
"""… and of a cell that is neither -1 nor from 0 to 100."""


def shapes_of_grid(message: Any) -> list[Placed]:
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
    picture = Picture(_colors(rows), (width * resolution, height * resolution))
    return [Placed(picture, message.header.frame_id, stamp_of(message.header), position, rotation)]


def _colors(cells: Any) -> Any:
    values = np.arange(256).astype(np.uint8).view(np.int8)
    table = np.empty((256, 4), np.uint8)
    table[:] = INVALID
    known = (values >= 0) & (values <= 100)
    light = 254 - (values[known].astype(np.int32) * 254) // 100
    table[known] = np.stack([light, light, light, np.full(len(light), 255)], axis=1)
    table[values == -1] = UNKNOWN
    return table[cells.view(np.uint8)]
