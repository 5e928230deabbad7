"""Resampling of images, as OpenCV 4's `remap` with INTER_CUBIC and a border of zeros.

A pixel is the weighted sum of the 4 by 4 pixels around its position in the source. Positions are rounded to 1/32 pixel.
Source of the weights: R. G. Keys, "Cubic convolution interpolation for digital image processing", 1981, with a = -0.75.
For uint8 they are integers with the sum 2 to the power of 15, as in OpenCV; else float32.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom.sensing.image_conversion import saturate

__all__ = ["remap_cubic"]

Array = NDArray[Any]

_STEPS = 32
_TAPS = 4
_WHOLE_BITS = 15
_A = np.float32(-0.75)
_ROWS_AT_ONCE = 64
"""Rows that are resampled at once, to bound the memory."""


def remap_cubic(image: Array, columns: Array, rows: Array) -> Array:
    """Return an image whose pixels are sampled at given positions of another.

    Args:
        image: Image (rows, columns) or (rows, columns, channels).
        columns: Horizontal position in `image` of each pixel of the result [px], float32 (height, width).
        rows: Vertical position [px], of the same shape.

    Returns:
        Image (height, width) or (height, width, channels) of the same type. Pixels outside of `image` are 0.
    """
    result = np.empty((*columns.shape, *image.shape[2:]), image.dtype)
    # Zeros on each side, to which positions outside are clipped.
    padded = np.pad(image, [(_TAPS, _TAPS), (_TAPS, _TAPS)] + [(0, 0)] * (image.ndim - 2))
    for start in range(0, len(columns), _ROWS_AT_ONCE):
        part = slice(start, start + _ROWS_AT_ONCE)
        result[part] = _resample(padded, image.dtype, columns[part], rows[part])
    return result


def _resample(padded: Array, dtype: np.dtype[Any], columns: Array, rows: Array) -> Array:
    left, across = _places(columns, padded.shape[1])
    top, down = _places(rows, padded.shape[0])
    in_whole_numbers = dtype == np.uint8
    weights = (_whole_weights() if in_whole_numbers else _weights())[down, across]
    wide = np.int32 if in_whole_numbers else np.float64 if dtype == np.float64 else np.float32
    total = np.zeros((*columns.shape, *padded.shape[2:]), wide)
    weights = weights.reshape(*columns.shape, *[1] * (padded.ndim - 2), _TAPS, _TAPS)
    for j in range(_TAPS):
        row = padded[top + j, left] * weights[..., j, 0]
        for i in range(1, _TAPS):
            row += padded[top + j, left + i] * weights[..., j, i]
        total += row
    if in_whole_numbers:
        total = total + (1 << _WHOLE_BITS - 1) >> _WHOLE_BITS
    return saturate(total, dtype)


def _places(places: Array, padded_length: int) -> tuple[Array, Array]:
    """Return the index of the first of the 4 padded pixels around each position, and its fraction in 1/32."""
    steps = np.rint(places.astype(np.float32) * np.float32(_STEPS))
    steps = np.clip(np.nan_to_num(steps, nan=-1e9), -1e9, 1e9).astype(np.int64)
    first = steps // _STEPS - 1 + _TAPS
    return np.clip(first, 0, padded_length - _TAPS), steps % _STEPS


@lru_cache(maxsize=1)
def _weights() -> Array:
    """Return weights (32, 32, 4, 4), by the fractions down and across, of rows and columns."""
    x = np.arange(_STEPS, dtype=np.float32) / np.float32(_STEPS)
    one = np.float32(1)
    first = ((_A * (x + one) - 5 * _A) * (x + one) + 8 * _A) * (x + one) - 4 * _A
    second = ((_A + 2) * x - (_A + 3)) * x * x + one
    third = ((_A + 2) * (one - x) - (_A + 3)) * (one - x) * (one - x) + one
    taps = np.stack([first, second, third, one - first - second - third], axis=-1)
    weights: Array = taps[:, None, :, None] * taps[None, :, None, :]
    return weights


@lru_cache(maxsize=1)
def _whole_weights() -> Array:
    """Return the weights times 2 to the power of 15, as int32. The error of rounding is added to an inner weight."""
    weights = saturate(_weights() * np.float32(1 << _WHOLE_BITS), np.dtype(np.int16)).astype(np.int32)
    flat = weights.reshape(_STEPS * _STEPS, _TAPS, _TAPS)
    for taps in flat:
        rest = (1 << _WHOLE_BITS) - int(taps.sum())
        if rest:
            inner = taps[2:, 2:]
            index = inner.argmin() if rest < 0 else inner.argmax()
            inner[np.unravel_index(index, inner.shape)] += rest
    return weights
