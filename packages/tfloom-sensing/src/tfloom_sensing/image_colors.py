"""Colour conversions of arrays, by OpenCV's cvtColor."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom_sensing.image_encodings import Encoding, ImageError
from tfloom_sensing.opencv import load_opencv

__all__ = ["change_color"]

Array = NDArray[Any]

_ORDERS = {"gray": "GRAY", "rgb": "RGB", "bgr": "BGR", "rgba": "RGBA", "bgra": "BGRA"}
"""OpenCV's names of orders of channels."""

_MOSAICS = {"bayer_rggb": "BG", "bayer_bggr": "RG", "bayer_gbrg": "GR", "bayer_grbg": "GB"}
"""OpenCV's names of mosaics, which are the colours of the pixels (1, 1) and (1, 2)."""

_YUV = {"uyvy": "UYVY", "yuyv": "YUY2", "nv12": "NV12", "nv21": "NV21", "nv24": "NV12"}
"""OpenCV's names of YUV formats. It has no NV24, which is converted as NV12 of the double size."""


def change_color(image: Array, source: Encoding, target: Encoding) -> Array:
    """Return an image in the colour format of `target`; the type of its values stays.

    Args:
        image: Image (rows, columns) or (rows, columns, channels) of uint8 or uint16.
        source: Its encoding.
        target: Encoding of the result.

    Raises:
        ImageError: the conversion is not supported, or the image's size is invalid for its format.
        ImportError: OpenCV is not installed.
    """
    code = _conversion_code(source, target)
    if source.color in _YUV and source.color != "nv24" and image.shape[1] % 2:
        raise ImageError(f"a [{source.name}] image has an even width, not {image.shape[1]}")
    if source.is_planar:
        source.height(len(image))  # raises ImageError if the planes do not fit
    if source.color == "nv24":
        doubled = _convert(_nv12_of_double_size(image), code)
        return np.ascontiguousarray(doubled[::2, ::2])
    return _convert(image, code)


def _conversion_code(source: Encoding, target: Encoding) -> str:
    """Return the name of OpenCV's code, as `COLOR_RGB2BGR`."""
    order = _ORDERS.get(target.color)
    if order is not None:
        if source.color in _ORDERS:
            return f"COLOR_{_ORDERS[source.color]}2{order}"
        if source.color in _MOSAICS and target.color in {"gray", "rgb", "bgr"}:
            return f"COLOR_Bayer{_MOSAICS[source.color]}2{order}"
        if source.color in _YUV:
            # Grey is the plane of luma, for which OpenCV has one name.
            layout = "NV21" if source.is_planar and order == "GRAY" else _YUV[source.color]
            return f"COLOR_YUV2{order}_{layout}"
    raise ImageError(f"Unsupported conversion from [{source.name}] to [{target.name}]")


def _convert(image: Array, code: str) -> Array:
    opencv = load_opencv()
    try:
        converted: Array = opencv.cvtColor(np.ascontiguousarray(image), getattr(opencv, code))
    except opencv.error as error:
        raise ImageError(f"OpenCV cannot convert an image of shape {image.shape}: {error}") from None
    return converted


def _nv12_of_double_size(image: Array) -> Array:
    """Return an NV24 image with each pixel of luma four times: as in NV12, a pair of chroma is for 2 by 2 pixels."""
    height, width = len(image) // 3, image.shape[1]
    luma = image[:height].repeat(2, 0).repeat(2, 1)
    return np.concatenate([luma, image[height:].reshape(height, 2 * width)])
