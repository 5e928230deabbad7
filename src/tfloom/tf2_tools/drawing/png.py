"""A picture as a PNG."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import cycle, pairwise
from math import hypot

from PIL import Image, ImageDraw, ImageFont

from tfloom.tf2_tools.drawing.shapes import Box, Curve, Group, Path, Pen, Picture, Point, Shape, Text

RESOLUTION = 2.0
"""Pixels for each point: 144 dpi."""
FINER = 2
"""Each pixel is averaged from this many, in x and in y."""
MAX_PIXELS = 16e6
"""A larger picture has fewer pixels for each point."""
STEPS = 24
"""Straight lines for a curve."""


def png_bytes(picture: Picture) -> bytes:
    """Return the picture as a PNG of 144 dpi, or of fewer if it is large."""
    points = picture.width * picture.height
    resolution = min(RESOLUTION, (MAX_PIXELS / points) ** 0.5)
    size = max(1, round(picture.width * resolution)), max(1, round(picture.height * resolution))
    image = Image.new("RGB", (size[0] * FINER, size[1] * FINER), "#ffffff")
    _Painter(ImageDraw.Draw(image), resolution * FINER).draw(picture.shapes)
    file = io.BytesIO()
    dots = resolution * 72.0
    image.reduce(FINER).save(file, "PNG", dpi=(dots, dots))
    return file.getvalue()


@cache
def _face(path: str, index: int, size: float) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(path, size, index, layout_engine=ImageFont.Layout.BASIC)


class _Painter:
    """Draws with `scale` pixels for each point."""

    def __init__(self, image: ImageDraw.ImageDraw, scale: float) -> None:
        self._image = image
        self._scale = scale

    def draw(self, shapes: Sequence[Shape]) -> None:
        for shape in shapes:
            match shape:
                case Group():
                    self.draw(shape.shapes)
                case Box():
                    self._draw_box(shape)
                case Path():
                    if shape.fill is not None:
                        self._image.polygon(self._pixels(shape.points), fill=shape.fill)
                    if shape.pen is not None:
                        self._stroke(shape.points, shape.pen)
                case Curve():
                    self._stroke(list(_curve_points(shape)), shape.pen)
                case Text():
                    self._draw_text(shape)

    def _pixels(self, points: Sequence[Point]) -> list[Point]:
        return [(x * self._scale, y * self._scale) for x, y in points]

    def _draw_box(self, box: Box) -> None:
        corners = self._pixels([(box.x, box.y), (box.x + box.width, box.y + box.height)])
        if box.pen is None or not box.pen.dash:
            self._image.rounded_rectangle(
                corners,
                radius=box.radius * self._scale,
                fill=box.fill,
                outline=None if box.pen is None else box.pen.color,
                width=1 if box.pen is None else self._width(box.pen),
            )
            return
        self._image.rounded_rectangle(corners, radius=box.radius * self._scale, fill=box.fill)
        right, bottom = box.x + box.width, box.y + box.height
        outline = [(box.x, box.y), (right, box.y), (right, bottom), (box.x, bottom), (box.x, box.y)]
        self._stroke(outline, box.pen)

    def _width(self, pen: Pen) -> int:
        return max(1, round(pen.width * self._scale))

    def _stroke(self, points: Sequence[Point], pen: Pen) -> None:
        for part in _dashes(points, pen.dash) if pen.dash else [points]:
            self._image.line(self._pixels(part), fill=pen.color, width=self._width(pen), joint="curve")

    def _draw_text(self, text: Text) -> None:
        for face, x, part in text.font.placed_runs(text.x, text.text):
            font = _face(face.path, face.index, text.font.size * self._scale)
            place = x * self._scale, text.y * self._scale
            self._image.text(place, part, fill=text.color, font=font, anchor="ls")


def _curve_points(curve: Curve) -> Iterator[Point]:
    (x0, y0), (x1, y1), (x2, y2), (x3, y3) = curve.points
    for step in range(STEPS + 1):
        t = step / STEPS
        a, b, c, d = (1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3
        yield a * x0 + b * x1 + c * x2 + d * x3, a * y0 + b * y1 + c * y2 + d * y3


def _dashes(points: Sequence[Point], dash: tuple[float, ...]) -> Iterator[list[Point]]:
    """Yield the parts of a line that dashes cover; none of `dash` is 0."""
    lengths = cycle(dash)
    left, is_drawn = next(lengths), True
    part = [points[0]]
    for start, end in pairwise(points):
        length = hypot(end[0] - start[0], end[1] - start[1])
        done = 0.0
        while length - done > left:
            done += left
            here = (
                start[0] + (end[0] - start[0]) * done / length,
                start[1] + (end[1] - start[1]) * done / length,
            )
            if is_drawn:
                yield [*part, here]
            part = [here]
            left, is_drawn = next(lengths), not is_drawn
        left -= length - done
        part.append(end)
    if is_drawn and len(part) > 1:
        yield part
