"""Bilinear demosaicing of Bayer images, with results equal to OpenCV's cvtColor.

A missing colour of a pixel is the mean of the nearest neighbours of that colour. The outermost pixels, which lack
neighbours, are copies of the pixels next to them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["bayer_to_gray", "bayer_to_rgb"]

Array = NDArray[Any]

_LUMA_BITS = 14
_LUMA = {"r": 4899, "g": 9617, "b": 1868}
"""0.299, 0.587 and 0.114 of ITU-R BT.601, times 2 to the power of 14."""


def bayer_to_rgb(image: Array, mosaic: str) -> Array:
    """Return the image (rows, columns, 3), red first, of a mosaic.

    Args:
        image: Mosaic (rows, columns), uint8 or uint16.
        mosaic: The colours of its first two rows and columns, as `rggb`.
    """
    rgb = np.zeros((*image.shape, 3), image.dtype)
    sums = _Sums(image)
    for row, column, color, beside in _sites(mosaic):
        here = sums.inner(row, column)
        out = rgb[1:-1, 1:-1][here]
        if color == "g":
            out[..., "rgb".index(beside)] = sums.left_right[here] + 1 >> 1
            out[..., 2 - "rgb".index(beside)] = sums.above_below[here] + 1 >> 1
        else:
            out[..., 1] = sums.cross[here] + 2 >> 2
            out[..., 2 - "rgb".index(color)] = sums.corners[here] + 2 >> 2
        out[..., "rgb".index(color)] = sums.own[here]
    return _repeat_outwards(rgb)


def bayer_to_gray(image: Array, mosaic: str) -> Array:
    """Return the luma (rows, columns) of a mosaic, rounded once, from the sums of neighbours.

    Args:
        image: Mosaic (rows, columns), uint8 or uint16.
        mosaic: The colours of its first two rows and columns, as `rggb`.
    """
    gray = np.zeros_like(image)
    sums = _Sums(image)
    opposite = {"r": "b", "b": "r"}
    for row, column, color, beside in _sites(mosaic):
        here = sums.inner(row, column)
        if color == "g":
            shift = _LUMA_BITS + 1
            luma = 2 * _LUMA["g"] * sums.own[here] + _LUMA[beside] * sums.left_right[here]
            luma += _LUMA[opposite[beside]] * sums.above_below[here]
        else:
            shift = _LUMA_BITS + 2
            luma = 4 * _LUMA[color] * sums.own[here] + _LUMA["g"] * sums.cross[here]
            luma += _LUMA[opposite[color]] * sums.corners[here]
        gray[1:-1, 1:-1][here] = luma + (1 << shift - 1) >> shift
    return _repeat_outwards(gray)


class _Sums:
    """Sums of the neighbours of each inner pixel."""

    def __init__(self, image: Array) -> None:
        wide = image.astype(np.int64)
        above, here, below = wide[:-2], wide[1:-1], wide[2:]
        self.own = here[:, 1:-1]
        self.left_right = here[:, :-2] + here[:, 2:]
        self.above_below = above[:, 1:-1] + below[:, 1:-1]
        self.cross = self.left_right + self.above_below
        self.corners = above[:, :-2] + above[:, 2:] + below[:, :-2] + below[:, 2:]

    @staticmethod
    def inner(row: int, column: int) -> tuple[slice, slice]:
        """Return the index of the inner pixels at (row, column) of the mosaic."""
        return slice(1 - row, None, 2), slice(1 - column, None, 2)


def _sites(mosaic: str) -> list[tuple[int, int, str, str]]:
    """Return row, column and colour of a mosaic's four pixels, and the colour of the horizontal neighbour."""
    return [(index // 2, index % 2, color, mosaic[index ^ 1]) for index, color in enumerate(mosaic)]


def _repeat_outwards(image: Array) -> Array:
    if min(image.shape[:2]) > 2:
        image[:, 0], image[:, -1] = image[:, 1], image[:, -2]
        image[0], image[-1] = image[1], image[-2]
    return image
