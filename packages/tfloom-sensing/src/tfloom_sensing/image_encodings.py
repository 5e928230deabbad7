"""The encodings of sensor_msgs/Image: the types, channels and colours of pixels."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

__all__ = ["Encoding", "ImageError", "find_encoding"]


class ImageError(RuntimeError):
    """An image or encoding is invalid, or a conversion is not supported."""


class Encoding(NamedTuple):
    """The layout of an image's pixels."""

    name: str
    dtype: np.dtype[Any]
    channels: int
    """Values per pixel; 1 for images of several planes, which are stored below each other."""
    color: str = ""
    """The channels in order, as `rgb`; `gray`; a YUV format; `bayer_` and the first two rows of the mosaic. Empty if
    the channels are not colours."""
    array_rows: tuple[int, int] = (1, 1)
    """Ratio of the array's rows to the image's: (3, 2) if a plane of half the height follows."""

    @property
    def bits(self) -> int:
        """Size of a value [bit]."""
        return self.dtype.itemsize * 8

    @property
    def is_planar(self) -> bool:
        """Whether the image is stored in planes."""
        return self.array_rows != (1, 1)

    def rows(self, height: int) -> int:
        """Return the number of rows of the array for an image of `height` rows."""
        of_array, of_picture = self.array_rows
        return -(-height * of_array // of_picture)

    def height(self, rows: int) -> int:
        """Return the height of the image [px] in an array of `rows` rows.

        Raises:
            ImageError: an image of this encoding never has `rows` rows.
        """
        of_array, of_picture = self.array_rows
        if rows % of_array:
            raise ImageError(
                f"an array of a [{self.name}] image has a multiple of {of_array} rows, not {rows}"
            )
        return rows // of_array * of_picture


_DEPTHS = {"8U": "u1", "8S": "i1", "16U": "u2", "16S": "i2", "32S": "i4", "32F": "f4", "64F": "f8"}
_NUMBERS = re.compile(rf"({'|'.join(_DEPTHS)})(?:C([0-9]+))?")
_YUV = {"yuv422": "uyvy", "uyvy": "uyvy", "yuv422_yuy2": "yuyv", "yuyv": "yuyv"}
_PLANES = {"nv12": (3, 2), "nv21": (3, 2), "nv24": (3, 1)}


def _named() -> dict[str, Encoding]:
    """Return the colour encodings by name.

    Source: sensor_msgs, include/sensor_msgs/image_encodings.hpp, and the kernel's description of the YUV formats.
    """
    encodings = []
    for bits, dtype in ((8, np.dtype(np.uint8)), (16, np.dtype(np.uint16))):
        encodings.append(Encoding(f"mono{bits}", dtype, 1, "gray"))
        encodings += [
            Encoding(f"{order}{bits}", dtype, len(order), order) for order in ("rgb", "bgr", "rgba", "bgra")
        ]
        encodings += [
            Encoding(f"bayer_{mosaic}{bits}", dtype, 1, f"bayer_{mosaic}")
            for mosaic in ("rggb", "bggr", "gbrg", "grbg")
        ]
    byte = np.dtype(np.uint8)
    encodings += [Encoding(name, byte, 2, color) for name, color in _YUV.items()]
    encodings += [Encoding(name, byte, 1, name, rows) for name, rows in _PLANES.items()]
    return {encoding.name: encoding for encoding in encodings}


_NAMED = _named()


@lru_cache(maxsize=256)
def find_encoding(name: str) -> Encoding:
    """Return an encoding by name: a colour format, or a type with any number of channels, as `16UC1`.

    Raises:
        ImageError: the name is unknown.
    """
    named = _NAMED.get(name)
    if named is not None:
        return named
    match = _NUMBERS.fullmatch(name)
    if match is None or match[2] == "0":
        raise ImageError(f"Unrecognized image encoding [{name}]")
    return Encoding(name, np.dtype(_DEPTHS[match[1]]), int(match[2] or 1))
