"""Conversions between image encodings, by the rules of cv_bridge."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom_sensing.image_colors import change_color
from tfloom_sensing.image_encodings import Encoding, ImageError, find_encoding

__all__ = ["cvtColor2", "saturate"]

Array = NDArray[Any]

_INT_MIN = -(2**31)
_SCALE = 257
"""65535 / 255: from the range of 8 bits to that of 16."""


def cvtColor2(m: Array, encoding_in: str, encoding_out: str) -> Array:
    """Return an image in another encoding, as a new array.

    Colours are converted to colours, and other channels to as many channels. Between 8 and 16 bits, values are scaled
    by 257, so that the ranges correspond; every other change of type rounds and clips.

    Args:
        m: Image (rows, columns) or (rows, columns, channels).
        encoding_in: Its encoding.
        encoding_out: Encoding of the result; empty: the same.

    Raises:
        RuntimeError: an encoding is unknown, the array does not match `encoding_in`, or the conversion is not
            supported.
        ImportError: OpenCV is not installed, and colours are to be converted.
    """
    source = _find(encoding_in)
    target = _find(encoding_out or encoding_in)
    _check(m, source)
    if _is_to_change_color(source, target):
        m = change_color(m, source, target)
    return _change_depth(m, source.bits, target)


def _find(name: str) -> Encoding:
    try:
        return find_encoding(name)
    except ImageError:
        raise ImageError(f"Unknown encoding {name}") from None


def _check(image: Array, encoding: Encoding) -> None:
    channels = image.shape[2] if image.ndim == 3 else 1
    if image.ndim not in {2, 3} or (image.dtype, channels) != (encoding.dtype, encoding.channels):
        raise ImageError(
            f"an array of a [{encoding.name}] image has {encoding.channels} channel(s) of {encoding.dtype}, "
            f"not the shape {image.shape} of {image.dtype}"
        )


def _is_to_change_color(source: Encoding, target: Encoding) -> bool:
    """Return whether colours are to be converted. Raise ImageError if the conversion is not supported."""
    if source.name == target.name:
        return False
    if not source.color and target.color:
        raise ImageError(
            f"[{source.name}] is not a color format. but [{target.name}] is. The conversion does not make sense"
        )
    if not target.color:
        if source.channels == target.channels:
            return False
        if not source.color:
            raise ImageError(f"[{source.name}] and [{target.name}] do not have the same number of channel")
        raise ImageError(
            f"[{source.name}] is a color format but [{target.name}] is not so they must have the same OpenCV type, "
            "CV_8UC3, CV16UC1 ...."
        )
    return source.color != target.color or source.color.startswith("bayer_")


def _change_depth(image: Array, bits: int, target: Encoding) -> Array:
    if image.dtype == target.dtype:
        return np.array(image)
    if (bits, target.bits) == (8, 16):
        return saturate(image.astype(np.int32) * _SCALE, target.dtype)
    if (bits, target.bits) == (16, 8):
        return saturate(image / _SCALE, target.dtype)
    return saturate(image, target.dtype)


def saturate(numbers: Array, dtype: np.dtype[Any]) -> Array:
    """Return numbers as another type, rounded half to even and clipped.

    As in OpenCV, NaN and floating-point numbers outside the range of int32 are converted as the smallest int32.
    """
    if dtype.kind == "f":
        with np.errstate(over="ignore"):
            converted: Array = numbers.astype(dtype)
            return converted
    if numbers.dtype.kind == "f":
        rounded = np.rint(numbers)
        fits = (rounded >= _INT_MIN) & (rounded < -_INT_MIN)
        numbers = np.where(fits, rounded, _INT_MIN).astype(np.int64)
    limits = np.iinfo(dtype)
    clipped: Array = np.clip(numbers, limits.min, limits.max).astype(dtype)
    return clipped
