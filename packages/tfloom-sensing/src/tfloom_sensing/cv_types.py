"""OpenCV's numbers of pixel types, as `CV_8UC3`.

The low bits are the depth, those above them the number of channels less one. They meet at bit 3 up to OpenCV 4, which
ROS 2 Jazzy uses, and at bit 5 since OpenCV 5.
"""

from __future__ import annotations

from tfloom_sensing.image_encodings import find_encoding
from tfloom_sensing.opencv import load_opencv

__all__ = ["DEPTHS", "CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "cv_type", "getCvType"]

DEPTHS = {"uint8": 0, "int8": 1, "uint16": 2, "int16": 3, "int32": 4, "float32": 5, "float64": 6}
"""OpenCV's numbers of depths, by numpy's names."""


def _channels_shift() -> int:
    """Return the bit at which the number of channels starts."""
    return int(load_opencv().CV_8UC2).bit_length() - 1


def cv_type(depth: int, channels: int) -> int:
    """Return the number of a type."""
    return depth + (channels - 1 << _channels_shift())


def getCvType(encoding: str) -> int:
    """Return OpenCV's number for the pixels of an encoding: `cv2.CV_8UC3` for `bgr8`.

    Raises:
        RuntimeError: the encoding is unknown.
        ImportError: OpenCV is not installed.
    """
    image_format = find_encoding(encoding)
    return cv_type(DEPTHS[image_format.dtype.name], image_format.channels)


def CV_MAT_CNWrap(i: int) -> int:
    """Return the number of channels of a type."""
    return (i >> _channels_shift()) + 1


def CV_MAT_DEPTHWrap(i: int) -> int:
    """Return the depth of a type."""
    return i & (1 << _channels_shift()) - 1
