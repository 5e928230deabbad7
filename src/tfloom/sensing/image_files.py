"""Compressed images, as JPEG and PNG: by OpenCV if it is installed, else by Pillow."""

from __future__ import annotations

import io
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor

from tfloom.sensing.image_conversion import saturate
from tfloom.sensing.image_encodings import ImageError
from tfloom.sensing.opencv import find_opencv

__all__ = ["css_colors", "decode_picture", "encode_picture"]

Array = NDArray[Any]

_SUN_RASTER = {"sr", "ras"}
_SUN_RASTER_MAGIC = 0x59A66A95

# OpenCV's defaults, as far as Pillow has them.
_JPEG: dict[str, Any] = {"format": "JPEG", "quality": 95, "subsampling": "4:2:0"}
_TIFF: dict[str, Any] = {"format": "TIFF", "compression": "tiff_lzw"}
_PILLOW: dict[str, dict[str, Any]] = {
    "jpg": _JPEG,
    "jpeg": _JPEG,
    "jpe": _JPEG,
    "png": {"format": "PNG", "compress_level": 1},
    "bmp": {"format": "BMP"},
    "dib": {"format": "BMP"},
    "jp2": {"format": "JPEG2000"},
    "pbm": {"format": "PPM"},
    "pgm": {"format": "PPM"},
    "ppm": {"format": "PPM"},
    "tif": _TIFF,
    "tiff": _TIFF,
    "webp": {"format": "WEBP", "lossless": True},
}
_OCTETS = np.dtype(np.uint8)
_WORDS = np.dtype(np.uint16)
_FLOATS = np.dtype(np.float32)
_DEEPER: dict[str, tuple[np.dtype[Any], ...]] = {
    "png": (_WORDS,),
    "jp2": (_WORDS,),
    "pgm": (_WORDS,),
    "ppm": (_WORDS,),
    "tif": (_WORDS, _FLOATS),
    "tiff": (_WORDS, _FLOATS),
}
"""Types other than uint8 that a format can store."""
_WITH_ALPHA = {"png", "jp2", "tif", "tiff", "webp"}
_CHANNELS = {"pbm": {1}, "pgm": {1}, "ppm": {3}}
"""Numbers of channels of formats that do not store all."""


def decode_picture(octets: bytes) -> Array:
    """Return the image in a file: (rows, columns), or (rows, columns, 3 or 4) with blue first, of uint8 or uint16.

    Raises:
        ImageError: the bytes are not a readable image.
    """
    opencv = find_opencv()
    if opencv is None:
        return _decode_by_pillow(octets)
    picture: Array | None = None
    if octets:
        picture = opencv.imdecode(np.frombuffer(octets, np.uint8), opencv.IMREAD_UNCHANGED)
    if picture is None:
        raise ImageError(f"{len(octets)} bytes are not an image that OpenCV can read")
    return picture


def _decode_by_pillow(octets: bytes) -> Array:
    try:
        with Image.open(io.BytesIO(octets)) as file:
            return _array_of(file)
    except Exception as error:  # noqa: BLE001  # Pillow's readers raise many types on invalid files
        raise ImageError(f"{len(octets)} bytes are not an image that Pillow can read: {error}") from None


def _array_of(file: Image.Image) -> Array:
    if file.mode == "I" and file.format == "TIFF":
        return np.asarray(file)
    if file.mode.startswith("I"):
        return saturate(np.asarray(file), _WORDS)
    if file.mode == "F":
        return np.asarray(file)
    has_alpha = "A" in file.mode or "transparency" in file.info
    if not has_alpha and file.mode in {"1", "L"}:
        return np.asarray(file.convert("L"))
    pixels = np.asarray(file.convert("RGBA" if has_alpha else "RGB"))
    return np.ascontiguousarray(pixels[..., [2, 1, 0, 3][: pixels.shape[2]]])


def encode_picture(image: Array, ending: str) -> bytes:
    """Return an image as the bytes of a file.

    Args:
        image: Image (rows, columns), or (rows, columns, 1, 3 or 4) with blue first, of uint8 or uint16. Other types
            are rounded and clipped if the format stores 8 bits only.
        ending: File name extension of the format: `jpg`, `png`.

    Raises:
        ImageError: the format is unknown, or cannot store the image.
    """
    if image.ndim not in {2, 3} or not image.size or (image.ndim == 3 and image.shape[2] not in {1, 3, 4}):
        raise ImageError(
            f"no file format stores an image of shape {image.shape}; it can store 1, 3 or 4 channels"
        )
    opencv = find_opencv()
    if opencv is None:
        return _encode_by_pillow(image, ending)
    try:
        done, octets = opencv.imencode(f".{ending}", image)
    except opencv.error as error:
        raise ImageError(f"OpenCV cannot write {image.dtype} {image.shape} as '{ending}': {error}") from None
    if not done:
        raise ImageError(f"OpenCV cannot write {image.dtype} {image.shape} as '{ending}'")
    return bytes(octets)


def _encode_by_pillow(image: Array, ending: str) -> bytes:
    options = _PILLOW.get(ending)
    if options is None and ending not in _SUN_RASTER:
        known = ", ".join(sorted(_PILLOW.keys() | _SUN_RASTER))
        raise ImageError(f"without OpenCV, '{ending}' cannot be written; known formats: {known}")
    pixels = _pixels_for(image, ending)
    if options is None:
        return _sun_raster(pixels)
    file = io.BytesIO()
    try:
        Image.fromarray(pixels).save(file, **options)
    except OSError as error:  # for example if Pillow was built without the format's library
        raise ImageError(f"Pillow cannot write {image.dtype} {image.shape} as '{ending}': {error}") from None
    return file.getvalue()


def _pixels_for(image: Array, ending: str) -> Array:
    """Return an image as Pillow takes it: red first, of a type that the format can store."""
    channels = image.shape[2] if image.ndim == 3 else 1
    if channels not in _CHANNELS.get(ending, {1, 3, 4}):
        raise ImageError(f"'{ending}' cannot store an image of {channels} channel(s)")
    if channels == 1:
        image = image.reshape(image.shape[:2])
    deeper = _DEEPER.get(ending, ())
    is_deeper = image.dtype in deeper
    if (is_deeper and channels > 1) or (_FLOATS in deeper and not is_deeper and image.dtype != _OCTETS):
        raise ImageError(
            f"without OpenCV, '{ending}' of {channels} channel(s) of {image.dtype} cannot be written"
        )
    if not is_deeper:
        image = saturate(image, _OCTETS)
    if ending == "pbm":
        return image > 0
    if ending == "pgm" and is_deeper:
        return image.astype(np.int32)  # the only 16-bit mode that Pillow before 10.1 writes as PGM
    if channels == 1:
        return image
    return np.ascontiguousarray(image[..., [2, 1, 0, 3][: channels if ending in _WITH_ALPHA else 3]])


def _sun_raster(image: Array) -> bytes:
    """Return an image as a Sun raster file: eight numbers, then rows of an even number of bytes, blue first."""
    height, width = image.shape[:2]
    rows = np.ascontiguousarray(image[..., ::-1] if image.ndim == 3 else image).reshape(height, -1)
    rows = np.pad(rows, ((0, 0), (0, rows.shape[1] % 2)))
    bits = 8 if image.ndim == 2 else 24
    standard, no_colormap = 1, 0
    head = struct.pack(">8I", _SUN_RASTER_MAGIC, width, height, bits, rows.size, standard, no_colormap, 0)
    return head + rows.tobytes()


def css_colors() -> dict[str, tuple[int, int, int]]:
    """Return red, green and blue of the named colours of CSS."""
    found = {}
    for name in ImageColor.colormap:
        red, green, blue = ImageColor.getrgb(name)[:3]
        found[name] = (red, green, blue)
    return found
