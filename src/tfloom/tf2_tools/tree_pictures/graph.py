"""A small tree as a graph: frames as boxes, each transform as an arrow with a card of its properties."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from tfloom.tf2_tools.drawing.colors import (
    FAINT,
    FRAME_STYLES,
    HAIRLINE,
    INK,
    LINE_COLORS,
    LOOP,
    NAME,
    PAPER,
    TEXT,
)
from tfloom.tf2_tools.drawing.fonts import elided, printable
from tfloom.tf2_tools.drawing.shapes import Box, Curve, Group, Path, Pen, Picture, Point, Shape, Text
from tfloom.tf2_tools.drawing.tree_layout import Layout, Size, arrange
from tfloom.tf2_tools.tree_pictures.header import HEADING, MARGIN, Header, line_pen
from tfloom.tf2_tools.tree_pictures.tree import DrawnEdge, FrameTree

ARROW = 13.0
CARD_PADDING = 5.0
COLUMN_GAP = 6.0
HEADER_GAP = 18.0
SIBLING_GAP = 14.0
GENERATION_GAP = 30.0
NAME_LIMIT = 32
"""Letters of a frame id on one line."""
MAX_LINES = 4
"""Lines of a frame id; the rest is left out, and is in the title of the group."""


def wrapped(name: str, limit: int = NAME_LIMIT) -> list[str]:
    """Break a long frame id into lines of `limit` letters at most, after `/`, `_`, `-` or `.` where there is one."""
    lines = []
    while len(name) > limit:
        # Only in the second half of the line, so that no line is much shorter than the others.
        cut = max(name.rfind(mark, limit // 2, limit) for mark in "/_-.") + 1 or limit
        lines.append(name[:cut])
        name = name[cut:]
    return [*lines, name]


def shortened(lines: list[str]) -> list[str]:
    """Return the first and the last of more than `MAX_LINES` lines, with `…` between them."""
    if len(lines) <= MAX_LINES:
        return lines
    return [*lines[: MAX_LINES - 2], "…", lines[-1]]


class NameBox:
    """A frame's name, broken into lines, and the size of its box."""

    def __init__(self, frame: str) -> None:
        self.lines = shortened(wrapped(printable(frame)))
        self.width = max(46.0, max(map(NAME.width, self.lines)) + 18.0)
        self.height = len(self.lines) * NAME.leading + 8.0

    def shapes(self, x: float, y: float, state: str) -> Iterator[Shape]:
        """Yield the box from its upper left corner."""
        fill, outline, letters = FRAME_STYLES[state]
        dash = (2.0, 2.0) if outline == LOOP else ()
        yield Box(x, y, self.width, self.height, fill, Pen(outline, 1.0, dash), 0.0 if dash else 5.0)
        for i, line in enumerate(self.lines):
            left = x + (self.width - NAME.width(line)) / 2
            yield Text(left, y + 4.0 + NAME.size * 0.95 + i * NAME.leading, line, NAME, letters)


class Card:
    """The properties of one transform, in two columns."""

    def __init__(self, edge: DrawnEdge) -> None:
        self.state = edge.state
        self.rows = [(name, elided(printable(value), TEXT, 130.0)) for name, value in card_rows(edge)]
        self.value_column = CARD_PADDING + max(TEXT.width(name) for name, _ in self.rows) + COLUMN_GAP
        self.width = self.value_column + max(TEXT.width(value) for _, value in self.rows) + CARD_PADDING
        self.height = len(self.rows) * TEXT.leading + 2 * CARD_PADDING - 1.0

    def shapes(self, x: float, y: float, _: str) -> Iterator[Shape]:
        """Yield the card from its upper left corner."""
        yield Box(x, y, self.width, self.height, PAPER, Pen(HAIRLINE, 0.7), 3.0)
        ink = FAINT if self.state == "stale" else INK
        for i, (name, value) in enumerate(self.rows):
            baseline = y + CARD_PADDING + TEXT.size * 0.88 + i * TEXT.leading
            yield Text(x + CARD_PADDING, baseline, name, TEXT, FAINT)
            yield Text(x + self.value_column, baseline, value, TEXT, ink)


def card_rows(edge: DrawnEdge) -> list[tuple[str, str]]:
    """Return the names and values of a transform's card."""
    record = edge.record
    rows = [("Broadcaster" if i == 0 else "and", name) for i, name in enumerate(edge.publishers)]
    if record.is_static:
        return [*rows, ("Static", "valid at all times")]
    return [
        *rows,
        ("Average rate", edge.rate_text),
        ("Buffer length", f"{record.buffer_length:.3f} s"),
        ("Newest transform", f"{record.most_recent:.6f} s"),
        ("Oldest transform", f"{record.oldest:.6f} s"),
    ]


class Graph:
    """A forest laid out one way: generations downwards, or sideways to the right."""

    def __init__(self, tree: FrameTree, *, sideways: bool) -> None:
        self.tree = tree
        self.sideways = sideways
        self.parents = {child: edge.record.parent for child, edge in tree.edges.items()}
        self.boxes = {frame: NameBox(frame) for frame in tree.frames}
        self.cards = {child: Card(edge) for child, edge in tree.edges.items()}
        self.layout = self._arrange()
        breadth, depth = self.layout.size
        self.width, self.height = (depth, breadth) if sideways else (breadth, depth)

    def unwieldiness(self) -> float:
        """Return the picture's longer side, with a bonus of half for a tree that grows downwards."""
        return max(self.width, self.height) * (1.5 if self.sideways else 1.0)

    def _arrange(self) -> Layout:
        starts = self.tree.layout.loop_starts
        sizes = {frame: self._cell_size(frame, is_loop=frame in starts) for frame in self.boxes}
        return arrange(self.parents, sizes, sibling_gap=SIBLING_GAP, generation_gap=GENERATION_GAP)

    def _cell_size(self, frame: str, *, is_loop: bool) -> Size:
        """Return the size of a frame with its card before it, and before that, in a loop, its parent again."""
        parts: list[NameBox | Card] = [self.boxes[frame]]
        if frame in self.cards:
            parts.append(self.cards[frame])
        if is_loop:
            parts.append(self.boxes[self.parents[frame]])
        breadth = max(part.height if self.sideways else part.width for part in parts)
        depth = sum(part.width if self.sideways else part.height for part in parts)
        return Size(breadth, depth + ARROW * (len(parts) - 1))

    def picture(self) -> Picture:
        """Return the page, as large as the tree needs."""
        header = Header(self.tree, self.width)
        width = max(self.width, header.width)
        shapes = list(header.shapes(MARGIN, MARGIN))
        left = MARGIN + (width - self.width) / 2
        top = MARGIN + header.height + HEADER_GAP
        # Siblings share a line's beginning, which a moving one shows.
        order = ("stale", "static", "live")
        for frame in sorted(self.cards, key=lambda frame: order.index(self.tree.edges[frame].state)):
            shapes += self._edge_shapes(frame, (left, top))
        for frame in self.boxes:
            shapes.append(self._cell(frame, (left, top)))
        return Picture(width + 2 * MARGIN, top + self.height + MARGIN, shapes, HEADING)

    def _point(self, origin: Point, breadth: float, depth: float) -> Point:
        """Return x and y on the page for a breadth and a depth."""
        x, y = (depth, breadth) if self.sideways else (breadth, depth)
        return origin[0] + x, origin[1] + y

    def _extent(self, part: NameBox | Card) -> float:
        """Return how far a part reaches along the depth."""
        return part.width if self.sideways else part.height

    def parts(self, frame: str) -> list[tuple[NameBox | Card, float, str]]:
        """Return the parts at a frame, from its parent's side: part, depth at which it begins, style."""
        column: list[tuple[NameBox | Card, str]] = []
        # The layout has cut a loop at this frame, which therefore is drawn as a root: its parent is drawn again above
        # it.
        is_loop = frame in self.layout.loop_starts
        if is_loop:
            column.append((self.boxes[self.parents[frame]], "loop"))
        if frame in self.cards:
            column.append((self.cards[frame], ""))
        state = self.tree.edges[frame].state if is_loop else self.tree.state_of(frame)
        column.append((self.boxes[frame], state))
        depth = self.layout.places[frame].depth
        parts = []
        for part, style in column:
            parts.append((part, depth, style))
            depth += self._extent(part) + ARROW
        return parts

    def _edge_shapes(self, frame: str, origin: Point) -> Iterator[Shape]:
        """Yield the curve from the parent's box to the frame's card, and the arrow from there."""
        breadth = self.layout.places[frame].breadth
        parts = self.parts(frame)
        state = self.tree.state_of(frame)
        # The curve ends at the first part, which is the card; arrows connect it with the parts that follow.
        if frame in self.parents and frame not in self.layout.loop_starts:
            parent = self.parents[frame]
            box, depth, _ = self.parts(parent)[-1]
            start = depth + self._extent(box), self.layout.places[parent].breadth
            yield from self._curve(origin, start, (parts[0][1], breadth), line_pen(state))
        for (part, depth, _), (_, end, _) in pairwise(parts):
            yield from self._arrow(origin, breadth, (depth + self._extent(part), end), state)

    def _curve(
        self, origin: Point, start: tuple[float, float], end: tuple[float, float], pen: Pen
    ) -> Iterator[Shape]:
        # Straight until there is room to bend, because a shallow parent's box ends before its generation does.
        (depth, breadth), (to_depth, to_breadth) = start, end
        bend = to_depth - GENERATION_GAP
        middle = to_depth - GENERATION_GAP / 2
        yield Path([self._point(origin, breadth, depth), self._point(origin, breadth, bend)], pen)
        points = (breadth, bend), (breadth, middle), (to_breadth, middle), (to_breadth, to_depth)
        first, second, third, last = (self._point(origin, *point) for point in points)
        yield Curve((first, second, third, last), pen)

    def _arrow(
        self, origin: Point, breadth: float, depths: tuple[float, float], state: str
    ) -> Iterator[Shape]:
        start, end = depths
        line = [self._point(origin, breadth, start), self._point(origin, breadth, end - 4.0)]
        yield Path(line, line_pen(state))
        head = [(breadth, end), (breadth - 2.6, end - 5.5), (breadth + 2.6, end - 5.5)]
        yield Path([self._point(origin, *point) for point in head], None, LINE_COLORS[state])

    def _cell(self, frame: str, origin: Point) -> Shape:
        breadth = self.layout.places[frame].breadth
        shapes: list[Shape] = []
        for part, depth, style in self.parts(frame):
            x, y = self._point(origin, breadth, depth)
            if self.sideways:
                y -= part.height / 2
            else:
                x -= part.width / 2
            shapes += part.shapes(x, y, style)
        return Group(shapes, self.tree.description_of(frame), frame)
