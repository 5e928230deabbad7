"""OpenCV's numbers of pixel types, as `CV_8UC3`.

The low three bits are the depth. The number of channels, minus one, starts at bit 3 up to OpenCV 4, which ROS 2 Jazzy
uses, and at bit 5 since OpenCV 5.
"""

from __future__ import annotations

from functools import lru_cache

from tfloom.sensing.image_encodings import find_encoding
from tfloom.sensing.opencv import find_opencv

__all__ = ["DEPTHS", "CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "channels_shift", "cv_type", "getCvType"]

DEPTHS = {"uint8": 0, "int8": 1, "uint16": 2, "int16": 3, "int32": 4, "float32": 5, "float64": 6}
"""OpenCV's numbers of depths, by numpy's names."""

_DEPTH_MASK = 0b111
_CHANNELS_SHIFT = 3


@lru_cache(maxsize=1)
def channels_shift() -> int:
    """Return the bit at which the number of channels starts."""
    opencv = find_opencv()
    return _CHANNELS_SHIFT if opencv is None else int(opencv.CV_8UC2).bit_length() - 1


def cv_type(depth: int, channels: int) -> int:
    """Return the number of a type."""
    return depth + (channels - 1 << channels_shift())


def getCvType(encoding: str) -> int:  # noqa: N802  # the reference's name
    """Return OpenCV's number for the pixels of an encoding: 16 for `bgr8`, which is `cv2.CV_8UC3`.

    Raises:
        RuntimeError: the encoding is unknown.
    """
    found = find_encoding(encoding)
    return cv_type(DEPTHS[found.dtype.name], found.channels)


def CV_MAT_CNWrap(i: int) -> int:  # noqa: N802  # the reference's name
    """Return the number of channels of a type."""
    return (i >> channels_shift()) + 1


def CV_MAT_DEPTHWrap(i: int) -> int:  # noqa: N802  # the reference's name
    """Return the depth of a type."""
    return i & _DEPTH_MASK
