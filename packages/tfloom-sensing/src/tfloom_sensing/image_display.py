"""Conversion of images for display: cv_bridge's cvtColorForDisplay."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom_sensing.image_conversion import cvtColor2, saturate
from tfloom_sensing.image_encodings import Encoding, ImageError, find_encoding
from tfloom_sensing.opencv import load_opencv

__all__ = ["cvtColorForDisplay"]

Array = NDArray[Any]

_WHERE = "cv_bridge.cvtColorForDisplay()"
_BACKGROUND_LABEL = -1
_BYTE = np.dtype(np.uint8)


def cvtColorForDisplay(
    source: Array,
    encoding_in: str,
    encoding_out: str,
    do_dynamic_scaling: bool = False,
    min_image_value: float = 0.0,
    max_image_value: float = 0.0,
    colormap: int = -1,
) -> Array:
    """Return an image in colours or greys of 8 bits.

    Labels (`32SC1` to `bgr8`) become one colour each, negative labels black.

    Args:
        source: Image (rows, columns) or (rows, columns, channels).
        encoding_in: Its encoding.
        encoding_out: A colour or grey format of 8 bits; empty: `bgr8`.
        do_dynamic_scaling: Whether to scale the image's smallest and largest finite values to 0 and 255.
        min_image_value: Value that is scaled to 0, for images of one channel.
        max_image_value: Value that is scaled to 255. If it equals `min_image_value`, values are not scaled.
        colormap: `cv2.COLORMAP_…` for scaled values; -1: greys.

    Raises:
        RuntimeError: the conversion is not supported.
        ImportError: OpenCV is not installed, and colours are to be converted.
    """
    encoding = find_encoding(encoding_in)
    target = _target(encoding, encoding_out)
    if target.name == "bgr8" and encoding_in == "32SC1":
        return _colors_of_labels(source)
    if do_dynamic_scaling:
        finite = source[np.isfinite(source)] if source.dtype.kind == "f" else source
        if not finite.size:
            raise ImageError(f"{_WHERE} scaling of an image without a finite number is impossible")
        min_image_value, max_image_value = float(finite.min()), float(finite.max())
        if min_image_value == max_image_value:
            return np.full((*source.shape[:2], 3), 128, np.uint8)
    if min_image_value != max_image_value:
        if encoding.channels != 1:
            raise ImageError(f"{_WHERE} scaling for images with more than one channel is unsupported")
        return _scaled(source, min_image_value, max_image_value, target, colormap)
    # As in the reference, depth images are interpreted as grey here.
    typed = "mono16" if encoding_in == "16UC1" else encoding_in
    if typed == target.name:
        return source
    try:
        return cvtColor2(source, typed, target.name)
    except ImageError as error:
        raise ImageError(
            f"{_WHERE} while trying to convert image from '{encoding_in}' to '{target.name}' an exception was thrown "
            f"({error})"
        ) from None


def _target(encoding: Encoding, wanted: str) -> Encoding:
    if not wanted:
        if encoding.bits > (32 if encoding.channels == 1 else 16):
            raise ImageError(f"{_WHERE} output encoding is empty and cannot be guessed.")
        return find_encoding("bgr8")
    target = find_encoding(wanted)
    if target.bits != 8 or not target.color or target.color.startswith("bayer_"):
        raise ImageError(
            f"{_WHERE} does not have an output encoding that is color or mono, and has is bit in depth"
        )
    return target


def _scaled(source: Array, low: float, high: float, target: Encoding, colormap: int) -> Array:
    shifted = saturate(source.astype(np.float64) - low, source.dtype)
    wide = np.float64 if source.dtype.itemsize > 4 else np.float32
    gray = saturate(shifted.astype(wide) * wide(255.0 / (high - low)), _BYTE)
    if colormap == -1:
        return cvtColor2(gray, "mono8", target.name)
    colored: Array = load_opencv().applyColorMap(gray, colormap)
    if source.dtype.kind == "f":
        colored[np.isnan(source)] = 0
    return cvtColor2(colored, "bgr8", target.name)


def _colors_of_labels(labels: Array) -> Array:
    """Return labels (rows, columns) as colours (rows, columns, 3), blue first; those below 0 are black."""
    palette = _palette()
    colored: Array = palette[np.fmod(labels, len(palette))]
    colored[(labels == _BACKGROUND_LABEL) | (np.fmod(labels, len(palette)) < 0)] = 0
    return colored


@lru_cache(maxsize=1)
def _palette() -> Array:
    """Return the colours of labels (146, 3), blue first.

    They are the named colours of CSS in alphabetical order, as in cv_bridge: values of 0 to 1 with three digits,
    without `paleturquoise`, whose value `palevioletred` has.
    """
    from PIL import ImageColor

    colors = {name: ImageColor.getrgb(name)[:3] for name in ImageColor.colormap}
    colors.pop("rebeccapurple", None)  # added by CSS 4
    colors["palevioletred"] = colors.pop("paleturquoise")
    rounded = [
        [float(f"{channel / 255:.3g}") for channel in reversed(colors[name])] for name in sorted(colors)
    ]
    return (np.array(rounded) * 255).astype(np.uint8)
