"""Pictures as a PDF, a page each, with embedded fonts: shapes on the canvas of reportlab.

The module `reportlab.graphics` has its own shapes and draws them on the same canvas. It would not replace this file,
because our shapes would have to become those: the pictures are the same, the code is as long, and both import and
drawing take longer. Our shapes stay, because those of reportlab have no SVG as is needed (see svg.py).
"""

from __future__ import annotations

import io
from collections.abc import Sequence

from reportlab.lib.colors import HexColor
from reportlab.pdfgen.canvas import Canvas

from tfloom.tf2_tools.drawing.shapes import Box, Curve, Group, Path, Pen, Picture, Shape, Text

PAGE_LIMIT = 14_400.0
"""The longest side that PDF readers support."""


def pdf_bytes(pages: Sequence[Picture]) -> bytes:
    """Return a PDF of the pictures, each on a page of its size; larger ones are scaled to `PAGE_LIMIT`."""
    file = io.BytesIO()
    canvas = Canvas(file, invariant=1)
    canvas.setTitle(pages[0].title)
    canvas.setCreator("tfloom")
    for page in pages:
        scale = min(1.0, PAGE_LIMIT / max(page.width, page.height))
        canvas.setPageSize((page.width * scale, page.height * scale))
        canvas.scale(scale, scale)
        _Page(canvas, page.height).draw(page.shapes)
        canvas.showPage()
    canvas.save()
    return file.getvalue()


class _Page:
    """A page of a canvas, whose y grows upwards."""

    def __init__(self, canvas: Canvas, height: float) -> None:
        self._canvas = canvas
        self._height = height

    def draw(self, shapes: Sequence[Shape]) -> None:
        for shape in shapes:
            match shape:
                case Group():
                    self.draw(shape.shapes)
                case Box():
                    self._draw_box(shape)
                case Path():
                    self._draw_path(shape)
                case Curve():
                    self._draw_curve(shape)
                case Text():
                    self._draw_text(shape)

    def _use(self, pen: Pen | None, fill: str | None) -> tuple[int, int]:
        """Set pen and fill; return whether to stroke and to fill, as reportlab takes them."""
        if pen is not None:
            self._canvas.setStrokeColor(HexColor(pen.color))
            self._canvas.setLineWidth(pen.width)
            self._canvas.setDash(list(pen.dash))
        if fill is not None:
            self._canvas.setFillColor(HexColor(fill))
        return int(pen is not None), int(fill is not None)

    def _draw_box(self, box: Box) -> None:
        stroke, fill = self._use(box.pen, box.fill)
        bottom = self._height - box.y - box.height
        self._canvas.roundRect(box.x, bottom, box.width, box.height, box.radius, stroke=stroke, fill=fill)

    def _draw_path(self, path: Path) -> None:
        stroke, fill = self._use(path.pen, path.fill)
        outline = self._canvas.beginPath()
        (x, y), *others = path.points
        outline.moveTo(x, self._height - y)
        for x, y in others:
            outline.lineTo(x, self._height - y)
        if fill:
            outline.close()
        self._canvas.drawPath(outline, stroke=stroke, fill=fill)

    def _draw_curve(self, curve: Curve) -> None:
        self._use(curve.pen, None)
        self._canvas.bezier(*(value for x, y in curve.points for value in (x, self._height - y)))

    def _draw_text(self, text: Text) -> None:
        self._canvas.setFillColor(HexColor(text.color))
        for face, x, part in text.font.placed_runs(text.x, text.text):
            self._canvas.setFont(face.name, text.font.size)
            self._canvas.drawString(x, self._height - text.y, part)
