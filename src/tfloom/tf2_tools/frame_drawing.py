"""A tf tree as a PDF: frames as boxes, each transform as an arrow with a card of its publisher and rate.

Sizes are in points of 1/72 inch; y grows upwards, as in PDF.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from reportlab.lib.colors import Color, HexColor, white
from reportlab.pdfgen.canvas import Canvas

from tfloom.tf2_tools.frame_records import NO_DATA, FrameRecord, parents_of
from tfloom.tf2_tools.page_fonts import Font, printable
from tfloom.tf2_tools.tree_layout import Layout, Size, arrange
from tfloom.whole_files import write_file

PAGE_LIMIT = 14_400.0
"""The longest side that PDF readers support."""
MARGIN = 28.0
ARROW = 13.0
CARD_PADDING = 5.0
COLUMN_GAP = 6.0
HEADER_GAP = 22.0
SIBLING_GAP = 16.0
GENERATION_GAP = 34.0
NAME_LIMIT = 32
"""Letters of a frame id on one line."""

INK = HexColor("#1c2733")
FAINT = HexColor("#6b7885")
LINE = HexColor("#8796a5")
HAIRLINE = HexColor("#d3dae1")
FILL = HexColor("#e3eefb")
OUTLINE = HexColor("#3d74b8")
ROOT_FILL = HexColor("#274b78")
LOOP = HexColor("#b3362b")


NAME = Font(is_bold=True, size=9.5)
TEXT = Font(is_bold=False, size=6.5)
TITLE = Font(is_bold=True, size=10.5)


def draw_frames(records: Sequence[FrameRecord], recorded_at: float, path: Path) -> None:
    """Write a PDF of one page, as large as the tree needs.

    Args:
        records: The frames; if empty, the page has a note instead.
        recorded_at: When they were gathered [s since epoch].
        path: File to write.

    Raises:
        OSError: `path` can't be written.
    """
    drawing = min(
        (_Drawing(records, sideways=sideways) for sideways in (False, True)), key=_Drawing.unwieldiness
    )
    drawing.write(recorded_at, path)


def wrapped(name: str, limit: int = NAME_LIMIT) -> list[str]:
    """Break a long frame id into lines of `limit` letters at most, after `/`, `_`, `-` or `.` where there is one."""
    lines = []
    while len(name) > limit:
        cut = max(name.rfind(mark, limit // 2, limit) for mark in "/_-.") + 1 or limit
        lines.append(name[:cut])
        name = name[cut:]
    return [*lines, name]


class _Box:
    """A frame's name, broken into lines, and the size of its box."""

    def __init__(self, frame: str) -> None:
        self.lines = wrapped(printable(frame))
        self.width = max(46.0, max(map(NAME.width, self.lines)) + 20.0)
        self.height = len(self.lines) * NAME.leading + 9.0


class _Card:
    """The card of one transform, in two columns."""

    def __init__(self, record: FrameRecord) -> None:
        self.rows: list[tuple[str, str]] = []
        for name, value in record.label():
            first, *more = wrapped(printable(value), 2 * NAME_LIMIT)
            self.rows += [(name, first), *(("", line) for line in more)]
        self.is_static = record.is_static
        self.value_column = CARD_PADDING + max(TEXT.width(name) for name, _ in self.rows) + COLUMN_GAP
        self.width = self.value_column + max(TEXT.width(value) for _, value in self.rows) + CARD_PADDING
        self.height = len(self.rows) * TEXT.leading + 2 * CARD_PADDING - 1.0


class _Drawing:
    """A forest laid out one way: generations downwards, or sideways to the right."""

    def __init__(self, records: Sequence[FrameRecord], *, sideways: bool) -> None:
        self.sideways = sideways
        self.parents = parents_of(records)
        self.boxes = {frame: _Box(frame) for frame in [*self.parents.values(), *self.parents]}
        self.cards = {record.child: _Card(record) for record in records}
        self.layout = self._arrange()
        breadth, depth = self.layout.size
        self.tree_width, self.tree_height = (depth, breadth) if sideways else (breadth, depth)

    def unwieldiness(self) -> float:
        """Return the picture's longer side, with a bonus of half for a tree that grows downwards."""
        return max(self.tree_width, self.tree_height) * (1.5 if self.sideways else 1.0)

    def _arrange(self) -> Layout:
        sizes = {frame: self._cell_size(frame, is_loop=False) for frame in self.boxes}
        trial = arrange(self.parents, sizes)
        sizes.update((frame, self._cell_size(frame, is_loop=True)) for frame in trial.loop_starts)
        return arrange(self.parents, sizes, sibling_gap=SIBLING_GAP, generation_gap=GENERATION_GAP)

    def _cell_size(self, frame: str, *, is_loop: bool) -> Size:
        """Return the size of a frame with its card before it, and before that, in a loop, its parent again."""
        parts: list[_Box | _Card] = [self.boxes[frame]]
        if frame in self.cards:
            parts.append(self.cards[frame])
        if is_loop:
            parts.append(self.boxes[self.parents[frame]])
        breadth = max(part.height if self.sideways else part.width for part in parts)
        depth = sum(part.width if self.sideways else part.height for part in parts)
        return Size(breadth, depth + ARROW * (len(parts) - 1))

    def write(self, recorded_at: float, path: Path) -> None:
        """Write the page."""
        legend = _Legend(recorded_at, loops=bool(self.layout.loop_starts), empty=not self.boxes)
        width = max(self.tree_width, legend.width) + 2 * MARGIN
        height = self.tree_height + HEADER_GAP + legend.height + 2 * MARGIN
        scale = min(1.0, PAGE_LIMIT / max(width, height))
        page = io.BytesIO()
        canvas = Canvas(page, pagesize=(width * scale, height * scale))
        canvas.setTitle("view_frames Result")
        canvas.setCreator("tfloom")
        canvas.scale(scale, scale)
        legend.draw(canvas, MARGIN, height - MARGIN)
        canvas.translate(MARGIN + max(0.0, (legend.width - self.tree_width) / 2), MARGIN + self.tree_height)
        for frame in self.boxes:
            self._draw_edge(canvas, frame)
        for frame in self.boxes:
            self._draw_cell(canvas, frame)
        canvas.save()
        write_file(path, page.getbuffer())

    def _point(self, breadth: float, depth: float) -> tuple[float, float]:
        """Return x and y on the page for a breadth and a depth, from the tree's upper left corner."""
        return (depth, -breadth) if self.sideways else (breadth, -depth)

    def _extent(self, part: _Box | _Card) -> float:
        """Return how far a part reaches along the depth."""
        return part.width if self.sideways else part.height

    def _parts(self, frame: str) -> list[tuple[_Box | _Card, float, str]]:
        """Return the parts at a frame, from its parent's side: part, depth at which it begins, style."""
        column: list[tuple[_Box | _Card, str]] = []
        if frame in self.layout.loop_starts:
            column.append((self.boxes[self.parents[frame]], "loop"))
        if frame in self.cards:
            column.append((self.cards[frame], "card"))
        column.append((self.boxes[frame], "frame" if frame in self.parents else "root"))
        depth = self.layout.places[frame].depth
        parts = []
        for part, style in column:
            parts.append((part, depth, style))
            depth += self._extent(part) + ARROW
        return parts

    def _draw_edge(self, canvas: Canvas, frame: str) -> None:
        """Draw the curve from the parent's box to the frame's card, and the arrow from there."""
        breadth = self.layout.places[frame].breadth
        parts = self._parts(frame)
        is_static = frame in self.cards and self.cards[frame].is_static
        canvas.setStrokeColor(LOOP if frame in self.layout.loop_starts else LINE)
        canvas.setLineWidth(1.0)
        canvas.setDash([3.0, 2.0] if is_static else [])
        if frame in self.parents and frame not in self.layout.loop_starts:
            parent = self.parents[frame]
            box, depth, _ = self._parts(parent)[-1]
            start = depth + self._extent(box), self.layout.places[parent].breadth
            self._draw_curve(canvas, *start, parts[0][1], breadth)
        for (part, depth, _), (_, end, _) in pairwise(parts):
            self._draw_arrow(canvas, breadth, depth + self._extent(part), end)
        canvas.setDash([])

    def _draw_curve(
        self, canvas: Canvas, depth: float, breadth: float, to_depth: float, to_breadth: float
    ) -> None:
        # Straight until there is room to bend, because a shallow parent's box ends before its generation does.
        bend = to_depth - GENERATION_GAP
        middle = to_depth - GENERATION_GAP / 2
        path = canvas.beginPath()
        path.moveTo(*self._point(breadth, depth))
        path.lineTo(*self._point(breadth, bend))
        path.curveTo(
            *self._point(breadth, middle),
            *self._point(to_breadth, middle),
            *self._point(to_breadth, to_depth),
        )
        canvas.drawPath(path)

    def _draw_arrow(self, canvas: Canvas, breadth: float, depth: float, to_depth: float) -> None:
        canvas.line(*self._point(breadth, depth), *self._point(breadth, to_depth - 4.0))
        path = canvas.beginPath()
        path.moveTo(*self._point(breadth, to_depth))
        path.lineTo(*self._point(breadth - 2.6, to_depth - 5.5))
        path.lineTo(*self._point(breadth + 2.6, to_depth - 5.5))
        path.close()
        canvas.setFillColor(LINE)
        canvas.drawPath(path, stroke=0, fill=1)

    def _draw_cell(self, canvas: Canvas, frame: str) -> None:
        breadth = self.layout.places[frame].breadth
        for part, depth, style in self._parts(frame):
            x, y = self._point(breadth, depth)
            if self.sideways:
                y += part.height / 2
            else:
                x -= part.width / 2
            if isinstance(part, _Card):
                _draw_card(canvas, part, x, y)
            else:
                _draw_box(canvas, part, x, y, *STYLES[style])


STYLES: dict[str, tuple[Color, Color, Color]] = {
    "root": (ROOT_FILL, ROOT_FILL, white),
    "frame": (FILL, OUTLINE, INK),
    "loop": (white, LOOP, LOOP),
}
"""Fill, outline and letters of a frame's box."""


def _draw_box(
    canvas: Canvas, box: _Box, x: float, y: float, fill: Color, outline: Color, letters: Color
) -> None:
    """Draw a frame's name in its box, whose upper left corner is at x, y."""
    canvas.setFillColor(fill)
    canvas.setStrokeColor(outline)
    canvas.setLineWidth(1.0)
    canvas.setDash([2.0, 2.0] if outline is LOOP else [])
    canvas.roundRect(x, y - box.height, box.width, box.height, 5.0, stroke=1, fill=1)
    canvas.setDash([])
    canvas.setFillColor(letters)
    for i, line in enumerate(box.lines):
        left = x + (box.width - NAME.width(line)) / 2
        NAME.draw(canvas, left, y - 4.5 - NAME.size * 0.92 - i * NAME.leading, line)


def _draw_card(canvas: Canvas, card: _Card, x: float, y: float) -> None:
    """Draw the card of a transform, from the upper left corner x, y."""
    canvas.setFillColor(white)
    canvas.setStrokeColor(HAIRLINE)
    canvas.setLineWidth(0.7)
    canvas.roundRect(x, y - card.height, card.width, card.height, 3.0, stroke=1, fill=1)
    for i, (name, value) in enumerate(card.rows):
        baseline = y - CARD_PADDING - TEXT.size * 0.88 - i * TEXT.leading
        canvas.setFillColor(FAINT)
        TEXT.draw(canvas, x + CARD_PADDING, baseline, name)
        canvas.setFillColor(INK)
        TEXT.draw(canvas, x + card.value_column, baseline, value)


class _Legend:
    """The page's title, time of recording and legend."""

    def __init__(self, recorded_at: float, *, loops: bool, empty: bool) -> None:
        self.lines = [f"Recorded at time: {recorded_at}"]
        self.lines.append(
            NO_DATA if empty else "solid line: transform over time, dashed line: static transform"
        )
        if loops:
            self.lines.append(
                "red dashed box: the tree loops back to this frame, so no lookup across it can work"
            )
        self.width = max([TITLE.width("view_frames Result"), *map(TEXT.width, self.lines)])
        self.height = TITLE.leading + len(self.lines) * TEXT.leading

    def draw(self, canvas: Canvas, x: float, y: float) -> None:
        """Draw the legend down from the upper left corner x, y."""
        canvas.setFillColor(INK)
        TITLE.draw(canvas, x, y - TITLE.size, "view_frames Result")
        canvas.setFillColor(FAINT)
        for i, line in enumerate(self.lines):
            TEXT.draw(canvas, x, y - TITLE.leading - TEXT.size - i * TEXT.leading, line)
