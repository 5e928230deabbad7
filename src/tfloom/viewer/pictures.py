"""Images of cameras, as files that browsers show, and pictures of such files."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.viewer.shapes import DisplayError

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from PIL.Image import Image as Picture

__all__ = ["opened_picture", "picture_of", "pixel_table", "small_pixels"]

MAX_BYTES = 64 * 1024 * 1024
MAX_SIDE_PX = 1280
"""Longer sides are reduced, because the page shows a picture smaller."""
MAX_PIXELS = 32_000_000
"""Size of a compressed image that is opened: a short file may claim any."""
OPENED_FORMATS = ("JPEG", "PNG", "WEBP")
JPEG_QUALITY = 80
BROWSER_FORMATS = {b"\xff\xd8\xff": "image/jpeg", b"\x89PNG\r\n\x1a\n": "image/png", b"RIFF": "image/webp"}
"""Types of files that browsers show, by their first bytes."""

LAYOUTS: dict[str, tuple[str, int]] = {
    "mono8": ("u1", 1),
    "mono16": ("u2", 1),
    "rgb8": ("u1", 3),
    "bgr8": ("u1", 3),
    "rgba8": ("u1", 4),
    "bgra8": ("u1", 4),
    "8UC1": ("u1", 1),
    "8UC3": ("u1", 3),
    "16UC1": ("u2", 1),
    "32FC1": ("f4", 1),
    "bayer_rggb8": ("u1", 1),
    "bayer_bggr8": ("u1", 1),
    "bayer_gbrg8": ("u1", 1),
    "bayer_grbg8": ("u1", 1),
}
"""Type and number of the channels of each encoding. Bayer patterns are shown as they are, in grey."""


def picture_of(message: Any) -> tuple[str, bytes]:
    """Return an image as a file: its type, and its bytes.

    Args:
        message: A `sensor_msgs/msg/Image` or `CompressedImage`.

    Raises:
        DisplayError: its encoding is unknown, or its sizes are wrong.
    """
    if hasattr(message, "format"):
        return _compressed(message)
    return "image/jpeg", _jpeg(_pixels(message))


def small_pixels(message: Any, max_side_px: int) -> NDArray[np.uint8]:
    """Return an image as red, green and blue (H, W, 3), with every second pixel, or every third, if it is larger.

    Args:
        message: A `sensor_msgs/msg/Image` or `CompressedImage`.
        max_side_px: The longest side [pixels].

    Raises:
        DisplayError: its encoding is unknown, its sizes are wrong, or its file is damaged.
    """
    if hasattr(message, "format"):
        pixels = np.asarray(_decoded(_compressed(message)[1], max_side_px))
    else:
        pixels = _pixels(message)
    reduction = -(-max(pixels.shape[:2]) // max_side_px)
    pixels = pixels[::reduction, ::reduction]
    return np.ascontiguousarray(
        np.repeat(pixels[:, :, np.newaxis], 3, axis=2) if pixels.ndim == 2 else pixels
    )


def opened_picture(data: bytes, max_side_px: int) -> Picture:
    """Return a JPEG, PNG or WebP as a picture of Pillow, of red, green and blue alone; a larger one is reduced.

    Args:
        data: The file.
        max_side_px: The longest side [pixels].

    Raises:
        DisplayError: it is none of these, it has too many pixels, or it is damaged.
    """
    if not data.startswith(tuple(BROWSER_FORMATS)):
        raise DisplayError("its file is neither JPEG, PNG nor WebP")
    picture = _decoded(data, max_side_px)
    picture.thumbnail((max_side_px, max_side_px))
    return picture


def _decoded(data: bytes, max_side_px: int) -> Picture:
    """Return a file as a picture of red, green and blue, at least as large as a size if the file is."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(io.BytesIO(data), formats=OPENED_FORMATS) as image:
            width, height = image.size
            if width * height <= MAX_PIXELS:
                image.draft("RGB", (max_side_px, max_side_px))  # a JPEG is decoded at a fraction of its size
                picture: Picture = image.convert("RGB")
                picture.format, picture.info = image.format, {}
                return picture
    except Image.DecompressionBombError:  # of so many that it isn't even looked at
        raise DisplayError("it has too many pixels to be opened") from None
    except UnidentifiedImageError:  # its text has an address
        raise DisplayError("its file is damaged: it does not begin as a picture does") from None
    except Exception as error:  # each format's reader has its own errors
        raise DisplayError(f"its file is damaged: {error}") from None
    raise DisplayError(f"it has {width} by {height} pixels, too many to be opened")


def _compressed(message: Any) -> tuple[str, bytes]:
    data = bytes(message.data)
    for start, kind in BROWSER_FORMATS.items():
        if data.startswith(start):
            return kind, data
    raise DisplayError(f"its format is {message.format[:60]!r}, and neither JPEG, PNG nor WebP")


def _pixels(message: Any) -> NDArray[np.uint8]:
    """Return the pixels as grey (H, W) or red, green and blue (H, W, 3)."""
    layout = LAYOUTS.get(message.encoding)
    if layout is None:
        raise DisplayError(f"its encoding is {message.encoding[:60]!r}, which is not shown")
    table = pixel_table(message, *layout)
    reduction = -(-max(table.shape[:2]) // MAX_SIDE_PX)
    table = table[::reduction, ::reduction]
    if layout[1] == 1:
        return _grey(table[:, :, 0])
    first = table[:, :, :3]
    return np.ascontiguousarray(first[:, :, ::-1] if message.encoding.startswith(("bgr", "8UC3")) else first)


def pixel_table(message: Any, kind: str, channels: int) -> NDArray[Any]:
    """Return the numbers of a `sensor_msgs/msg/Image` (H, W, channels), as a view of its data.

    Args:
        message: The image.
        kind: Type of a number, as numpy's without the byte order.
        channels: Number of channels.

    Raises:
        DisplayError: its sizes don't fit its data, or are zero.
    """
    dtype = np.dtype((">" if message.is_bigendian else "<") + kind)
    width, height, step = int(message.width), int(message.height), int(message.step)
    row = width * channels * dtype.itemsize
    if not width or not height:
        raise DisplayError("it has no pixels")
    data = memoryview(message.data).cast("B")
    if step < row or step > MAX_BYTES or len(data) < step * (height - 1) + row or len(data) > MAX_BYTES:
        raise DisplayError(f"its data has {len(data)} bytes, which don't fit {width} by {height} pixels")
    table: NDArray[Any] = np.ndarray(
        (height, width, channels), dtype, data, strides=(step, channels * dtype.itemsize, dtype.itemsize)
    )
    return table


def _grey(table: NDArray[Any]) -> NDArray[np.uint8]:
    """Return one channel as grey: bytes as they are, others from their least to their greatest."""
    if table.dtype == np.uint8:
        return np.ascontiguousarray(table)
    numbers = table.astype(np.float64)
    is_finite = np.isfinite(numbers)
    if not is_finite.any():
        return np.zeros(table.shape, np.uint8)
    low, high = np.percentile(numbers[is_finite], (1.0, 99.0))
    with np.errstate(over="ignore", invalid="ignore"):
        share = (numbers - low) / (high - low) if high > low else np.zeros(table.shape)
    return (255.0 * np.clip(np.nan_to_num(share), 0.0, 1.0)).astype(np.uint8)


def _jpeg(pixels: NDArray[np.uint8]) -> bytes:
    from PIL import Image

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=JPEG_QUALITY)
    return file.getvalue()
