"""The encodings of sensor_msgs/Image: what the numbers of a pixel are, and which colours they mean."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

__all__ = ["Encoding", "ImageError", "find_encoding"]


class ImageError(RuntimeError):
    """An image or an encoding can't be used as asked."""


class Encoding(NamedTuple):
    """What an encoding's name says."""

    name: str
    dtype: np.dtype[Any]
    channels: int
    """Numbers of a pixel; 1 for images of several planes, whose rows stand below each other."""
    color: str = ""
    """The channels in order, as `rgb`; `gray`; a YUV format; `bayer_` and the first two rows of its mosaic. Empty for
    numbers that are no colours."""
    array_rows: tuple[int, int] = (1, 1)
    """Rows of the array in each rows of the picture: (3, 2) where a plane of half height follows."""

    @property
    def bits(self) -> int:
        """Size of a number [bit]."""
        return self.dtype.itemsize * 8

    @property
    def is_planar(self) -> bool:
        """Whether planes follow each other in place of pixels."""
        return self.array_rows != (1, 1)

    def rows(self, height: int) -> int:
        """Return the rows of the array that holds a picture of a height [px]."""
        of_array, of_picture = self.array_rows
        return -(-height * of_array // of_picture)

    def height(self, rows: int) -> int:
        """Return the height of the picture [px] in an array with so many rows.

        Raises:
            ImageError: no picture has so many.
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
    """Return the encodings of colours.

    Source: sensor_msgs, include/sensor_msgs/image_encodings.hpp, and the kernel's description of the YUV formats.
    """
    found = []
    for bits, dtype in ((8, np.dtype(np.uint8)), (16, np.dtype(np.uint16))):
        found.append(Encoding(f"mono{bits}", dtype, 1, "gray"))
        found += [
            Encoding(f"{order}{bits}", dtype, len(order), order) for order in ("rgb", "bgr", "rgba", "bgra")
        ]
        found += [
            Encoding(f"bayer_{mosaic}{bits}", dtype, 1, f"bayer_{mosaic}")
            for mosaic in ("rggb", "bggr", "gbrg", "grbg")
        ]
    octet = np.dtype(np.uint8)
    found += [Encoding(name, octet, 2, color) for name, color in _YUV.items()]
    found += [Encoding(name, octet, 1, name, rows) for name, rows in _PLANES.items()]
    return {encoding.name: encoding for encoding in found}


_NAMED = _named()


@lru_cache(maxsize=256)
def find_encoding(name: str) -> Encoding:
    """Return an encoding by its name: a colour format, or numbers as in `16UC1`, with any number of channels.

    Raises:
        ImageError: there is none of that name.
    """
    named = _NAMED.get(name)
    if named is not None:
        return named
    match = _NUMBERS.fullmatch(name)
    if match is None or match[2] == "0":
        raise ImageError(f"Unrecognized image encoding [{name}]")
    return Encoding(name, np.dtype(_DEPTHS[match[1]]), int(match[2] or 1))
