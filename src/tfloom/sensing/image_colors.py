"""Colour conversions of arrays: OpenCV's cvtColor in integer arithmetic, with equal results.

An image is an array (rows, columns) or (rows, columns, channels) of uint8 or uint16. Sources: OpenCV's documentation of
its colour conversions; ITU-R BT.601 for luma, and for video range (luma 16 to 235, chroma 16 to 240 around 128).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom.sensing.bayer import bayer_to_gray, bayer_to_rgb
from tfloom.sensing.image_encodings import Encoding, ImageError

__all__ = ["change_color"]

Array = NDArray[Any]

_LUMA_BITS = 15
_LUMA = {"r": 9798, "g": 19235, "b": 3735}
"""0.299, 0.587 and 0.114 of BT.601, times 2 to the power of 15."""

_VIDEO_BITS = 20
_VIDEO_Y, _VIDEO_RV, _VIDEO_GU, _VIDEO_GV, _VIDEO_BU = 1220542, 1673527, -409993, -852492, 2116026
"""1.164, 1.596, -0.391, -0.813 and 2.018 of BT.601's video range, times 2 to the power of 20."""

_ORDERS = ("rgb", "bgr", "rgba", "bgra")


def change_color(image: Array, source: Encoding, target: Encoding) -> Array:
    """Return an image in the colour format of `target`; the type of its values stays.

    Raises:
        ImageError: the conversion is not supported, or the image's size is invalid for its format.
    """
    if source.color in _ORDERS and target.color in {"gray", *_ORDERS}:
        return _from_order(image, source.color, target.color)
    if source.color == "gray" and target.color in _ORDERS:
        return _assemble(dict.fromkeys("rgb", image), target.color)
    if source.color.startswith("bayer_") and target.color in {"gray", "rgb", "bgr"}:
        mosaic = source.color.removeprefix("bayer_")
        if target.color == "gray":
            return bayer_to_gray(image, mosaic)
        rgb = bayer_to_rgb(image, mosaic)
        return rgb if target.color == "rgb" else np.ascontiguousarray(rgb[..., ::-1])
    if source.color in {"uyvy", "yuyv", "nv12", "nv21", "nv24"} and target.color in {"gray", *_ORDERS}:
        return _from_yuv(image, source, target.color)
    raise ImageError(f"Unsupported conversion from [{source.name}] to [{target.name}]")


def _from_order(image: Array, order: str, wanted: str) -> Array:
    channels = {name: image[..., index] for index, name in enumerate(order)}
    if wanted != "gray":
        return _assemble(channels, wanted)
    red, green, blue = (channels[name].astype(np.int32) * _LUMA[name] for name in "rgb")
    luma = red + green + blue
    gray: Array = (luma + (1 << _LUMA_BITS - 1) >> _LUMA_BITS).astype(image.dtype)
    return gray


def _assemble(channels: dict[str, Array], order: str) -> Array:
    """Return the channels in an order; a missing alpha is opaque."""
    first = channels[order[0]]
    image = np.empty((*first.shape, len(order)), first.dtype)
    for index, name in enumerate(order):
        image[..., index] = channels[name] if name in channels else np.iinfo(first.dtype).max
    return image


def _from_yuv(image: Array, source: Encoding, order: str) -> Array:
    luma, u, v = _planes(image, source)
    if order == "gray":
        return np.ascontiguousarray(luma)
    # The share of chroma in each colour, computed once for all pixels with the same chroma.
    u_offset, v_offset = (plane.astype(np.int32) - 128 for plane in (u, v))
    half = 1 << _VIDEO_BITS - 1
    shares = {
        "r": half + _VIDEO_RV * v_offset,
        "g": half + _VIDEO_GU * u_offset + _VIDEO_GV * v_offset,
        "b": half + _VIDEO_BU * u_offset,
    }
    brightness = np.maximum(luma.astype(np.int32) - 16, 0) * _VIDEO_Y
    tall, wide = luma.shape[0] // u.shape[0], luma.shape[1] // u.shape[1]
    channels = {
        name: np.clip(brightness + share.repeat(tall, 0).repeat(wide, 1) >> _VIDEO_BITS, 0, 255).astype(
            np.uint8
        )
        for name, share in shares.items()
    }
    return _assemble(channels, order)


def _planes(image: Array, source: Encoding) -> tuple[Array, Array, Array]:
    """Return luma (height, width), and u and v, each of one value per block of pixels."""
    width = image.shape[1]
    if source.color != "nv24" and width % 2:
        raise ImageError(f"a [{source.name}] image has an even width, not {width}")
    if not source.is_planar:
        chroma = image[..., 0 if source.color == "uyvy" else 1]
        return image[..., 1 if source.color == "uyvy" else 0], chroma[:, 0::2], chroma[:, 1::2]
    height = source.height(len(image))
    pairs = image[height:].reshape(-1, width if source.color == "nv24" else width // 2, 2)
    first, second = pairs[..., 0], pairs[..., 1]
    return (image[:height], second, first) if source.color == "nv21" else (image[:height], first, second)
