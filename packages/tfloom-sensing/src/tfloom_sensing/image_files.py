"""Compressed images, as JPEG and PNG, by OpenCV."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom_sensing.image_encodings import ImageError
from tfloom_sensing.opencv import load_opencv

__all__ = ["decode_picture", "encode_picture"]

Array = NDArray[Any]


def decode_picture(content: bytes) -> Array:
    """Return the image in a file: (rows, columns), or (rows, columns, 3 or 4) with blue first, of uint8 or uint16.

    Raises:
        ImageError: the bytes are not a readable image.
        ImportError: OpenCV is not installed.
    """
    opencv = load_opencv()
    picture: Array | None = None
    try:
        if content:
            picture = opencv.imdecode(np.frombuffer(content, np.uint8), opencv.IMREAD_UNCHANGED)
    except opencv.error as error:  # for example of a size that is too large
        raise ImageError(f"{len(content)} bytes are not an image that OpenCV can read: {error}") from None
    if picture is None:
        raise ImageError(f"{len(content)} bytes are not an image that OpenCV can read")
    return picture


def encode_picture(image: Array, ending: str) -> bytes:
    """Return an image as the bytes of a file.

    Args:
        image: Image (rows, columns), or (rows, columns, 1, 3 or 4) with blue first, of uint8 or uint16. Other types
            are rounded and clipped if the format stores 8 bits only.
        ending: File name extension of the format: `jpg`, `png`.

    Raises:
        ImageError: the format is unknown, or cannot store the image.
        ImportError: OpenCV is not installed.
    """
    if image.ndim not in {2, 3} or not image.size or (image.ndim == 3 and image.shape[2] not in {1, 3, 4}):
        raise ImageError(
            f"no file format stores an image of shape {image.shape}; it can store 1, 3 or 4 channels"
        )
    opencv = load_opencv()
    try:
        is_written, content = opencv.imencode(f".{ending}", image)
    except opencv.error as error:
        raise ImageError(f"OpenCV cannot write {image.dtype} {image.shape} as '{ending}': {error}") from None
    if not is_written:
        raise ImageError(f"OpenCV cannot write {image.dtype} {image.shape} as '{ending}'")
    return bytes(content)
