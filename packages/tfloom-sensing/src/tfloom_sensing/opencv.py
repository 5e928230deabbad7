"""OpenCV: whichever of its distributions is installed. The only file that imports it.

None of them is a dependency, because each (`opencv-python`, `opencv-python-headless`, `opencv-contrib-python` …) has
the package `cv2`: a second one would overwrite the user's.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from tfloom_sensing.image_encodings import find_encoding

__all__ = ["DEPTHS", "CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "cv_type", "getCvType", "load_opencv"]


_PACKAGE = "opencv-python-headless"


@lru_cache(maxsize=1)
def load_opencv() -> Any:
    """Return the module `cv2`.

    Raises:
        ImportError: OpenCV is not installed, or a library that it needs is missing.
    """
    try:
        import cv2
    except ModuleNotFoundError as error:
        if error.name != "cv2":
            raise
        text = f"cv_bridge and image_geometry need OpenCV, which is not installed: pip install {_PACKAGE}"
        raise ModuleNotFoundError(text, name="cv2") from None
    except ImportError as error:
        # Mostly libGL.so.1, of the distributions that can open windows.
        text = f"the installed OpenCV cannot be imported: {error}; {_PACKAGE} needs no libraries of a display"
        raise ImportError(text, name="cv2") from None
    return cv2


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
