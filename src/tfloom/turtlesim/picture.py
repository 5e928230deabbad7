"""Raster pictures of the turtle window."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import Any, TypeAlias

from PIL import Image, ImageDraw

from tfloom.common.files import write_file

Color: TypeAlias = tuple[int, int, int]
Point: TypeAlias = tuple[float, float]
Box: TypeAlias = tuple[int, int, int, int]
"""Left, top, right and bottom [px]; right and bottom are outside."""
Picture: TypeAlias = Image.Image

OPAQUE = 255


def plain(side_px: int, color: Color) -> Picture:
    """Return a square RGB picture of one colour."""
    return Image.new("RGB", (side_px, side_px), color)


def from_rgb(pixels: bytes, side_px: int) -> Picture:
    """Return a square RGB picture from pixels as `Picture.tobytes` returns them."""
    return Image.frombytes("RGB", (side_px, side_px), pixels)


def to_png(picture: Picture) -> bytes:
    """Return a picture as the bytes of a PNG file."""
    file = io.BytesIO()
    picture.save(file, "PNG")
    return file.getvalue()


def save(picture: Picture, path: Path, **options: Any) -> None:
    """Write a picture to a file, in the format that the file's ending names, as .png.

    Raises:
        OSError: it can't be written.
    """
    file = io.BytesIO()
    # By the format's name, because Pillow's table of endings is complete only after it has loaded all its plug-ins.
    picture.save(file, path.suffix[1:].upper(), **options)
    write_file(path, file.getbuffer())


class Ink:
    """A square transparent picture to draw on, in opaque colours.

    Args:
        side_px: Width and height.
    """

    def __init__(self, side_px: int) -> None:
        self._image = Image.new("RGBA", (side_px, side_px))
        self._draw = ImageDraw.Draw(self._image)

    def line(self, ends: list[Point], color: Color, width_px: int) -> None:
        """Draw a line with round ends."""
        fill = (*color, OPAQUE)
        self._draw.line(ends, fill, width_px)
        radius = width_px / 2
        for x, y in ends:
            self._draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill)

    def polygon(self, points: list[Point], color: Color) -> None:
        """Fill a polygon with an opaque colour."""
        self._draw.polygon(points, fill=(*color, OPAQUE))

    def color_at(self, x: int, y: int) -> Color | None:
        """Return the colour of a pixel, or None where it is transparent."""
        pixel = self._image.getpixel((x, y))
        if not isinstance(pixel, tuple) or pixel[3] == 0:
            return None
        red, green, blue, _ = pixel
        return red, green, blue

    def reduced_picture(self, factor: int) -> Picture:
        """Return the picture, reduced by an integer factor."""
        return self._image.reduce(factor)

    def lay_onto(self, ground: Picture, part: Box, background: Color) -> None:
        """Replace a part of `ground`, in its own pixels, by the ink there, scaled, on `background`."""
        ratio = self._image.width / ground.width
        left, top, right, bottom = part
        x, y = int(left * ratio), int(top * ratio)
        # Cut out first, because resize() would copy the whole of an image with transparency.
        ink = self._image.crop((x, y, math.ceil(right * ratio), math.ceil(bottom * ratio)))
        source = (left * ratio - x, top * ratio - y, right * ratio - x, bottom * ratio - y)
        ink = ink.resize((right - left, bottom - top), Image.Resampling.BOX, source)
        ground.paste(background, part)
        ground.paste(ink, (left, top), ink)
