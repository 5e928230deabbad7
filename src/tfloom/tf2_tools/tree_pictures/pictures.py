"""A tree of frames as pictures, a graph if it is small enough to be read as one, else a table; and as a web page."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from html import escape
from itertools import pairwise
from pathlib import Path as FilePath
from typing import NamedTuple

from tfloom.tf2_tools.drawing.colors import (
    FAINT,
    FRAME_STYLES,
    HAIRLINE,
    INK,
    LOOP,
    ROW_NAME,
    ROW_TEXT,
    STALE,
    STRIPE,
)
from tfloom.tf2_tools.drawing.fonts import elided, printable
from tfloom.tf2_tools.drawing.shapes import Box, Group, Path, Pen, Picture, Shape, Text
from tfloom.tf2_tools.drawing.svg import svg_text
from tfloom.tf2_tools.tree_pictures.graph import Graph
from tfloom.tf2_tools.tree_pictures.header import HEADING, MARGIN, Header, line_pen
from tfloom.tf2_tools.tree_pictures.tree import DrawnEdge, FrameTree, tree_json

GRAPH_SIZE = (1130.0, 780.0)
"""The longer and the shorter side of the largest graph that can be read at once: an A3 page, in points."""
GRAPH_FRAMES = 60
"""A larger tree is not tried as a graph."""
A4 = (595.3, 841.9)
"""Points."""
WEB_PAGE = FilePath(__file__).with_name("web_page.html")
"""With a name in `@` where each text belongs; it has its style and its script in it, because it is one file."""


def draw_page(tree: FrameTree) -> Picture:
    """Return the tree on one page."""
    return _graph(tree) or one_page(tree)


def draw_pages(tree: FrameTree) -> list[Picture]:
    """Return the tree for printing: one page for a graph, or a table on pages of A4."""
    graph = _graph(tree)
    return [graph] if graph else pages(tree, A4)


def html_text(tree: FrameTree, picture: Picture) -> str:
    """Return a drawn tree as one web page: search, zoom, and the way from a frame to its root. It uses no network."""
    data = json.dumps(tree_json(tree), ensure_ascii=True, allow_nan=False).replace("<", "\\u003c")
    texts = {"@TITLE@": escape(picture.title), "@SVG@": svg_text(picture), "@DATA@": data}
    # In one pass, because a frame may have the name of a place.
    return re.sub("|".join(texts), lambda place: texts[place[0]], WEB_PAGE.read_text("utf-8"))


def _graph(tree: FrameTree) -> Picture | None:
    """Return a small tree as a graph; None if it is larger than `GRAPH_SIZE`."""
    if len(tree.frames) > GRAPH_FRAMES:
        return None
    graph = min((Graph(tree, sideways=sideways) for sideways in (False, True)), key=Graph.unwieldiness)
    longer, shorter = max(graph.width, graph.height), min(graph.width, graph.height)
    return graph.picture() if longer <= GRAPH_SIZE[0] and shorter <= GRAPH_SIZE[1] else None


ROW = 13.0
INDENT = 14.0
MAX_INDENT = 190.0
"""Room for indentation: in a deeper tree each level has less."""
NAME_WIDTH = 150.0
"""Room for a frame's name."""
PUBLISHER_WIDTH = 110.0
GAP = 8.0
COLUMN_GAP = 26.0
HEADER_GAP = 14.0
HEADINGS = ("Frame", "Published by", "Rate", "Buffer", "Newest", "Oldest")
NOTE = "Newest, oldest: seconds before the newest transform of the tree. Buffer: seconds between them."
GUIDE = Pen("#b9c4cf", 0.8)
DASH = (2.0, 1.5)
"""Of a static transform, whose line is short here."""


class Row(NamedTuple):
    """The row of a frame, with the lines that lead to its parent."""

    frame: str
    level: int
    state: str
    cells: tuple[str, ...]
    """The texts of all columns; the first is the frame's name."""
    guides: tuple[bool, ...]
    """For each level above the frame's own, whether its line goes on below this row."""


class Table:
    """The rows of a tree and the widths of their columns."""

    def __init__(self, tree: FrameTree) -> None:
        self.tree = tree
        self.rows = list(_rows(tree))
        depth = max((row.level for row in self.rows), default=0)
        self.indent = min(INDENT, MAX_INDENT / max(1, depth))
        self._widths = [
            max([ROW_TEXT.width(heading), *(self._cell_width(row, i) for row in self.rows)])
            for i, heading in enumerate(HEADINGS)
        ]
        self.width = sum(self._widths) + GAP * (len(HEADINGS) - 1)
        self._lefts = [sum(self._widths[:i]) + GAP * i for i in range(len(HEADINGS))]

    def _cell_width(self, row: Row, column: int) -> float:
        width = (ROW_NAME if column == 0 else ROW_TEXT).width(row.cells[column])
        return width + row.level * self.indent + 10.0 if column == 0 else width

    def height(self, rows: int) -> float:
        """Return the height of this many rows with their headings."""
        return (rows + 1) * ROW

    def shapes(self, rows: range, x: float, y: float) -> Iterator[Shape]:
        """Yield headings and rows from their upper left corner."""
        for i, heading in enumerate(HEADINGS):
            left = x + self._lefts[i] + self._shift(i, heading)
            yield Text(left, y + ROW * 0.68, heading, ROW_TEXT, FAINT)
        yield Path([(x, y + ROW), (x + self.width, y + ROW)], Pen(HAIRLINE, 0.8))
        for place, index in enumerate(rows, 1):
            top = y + place * ROW
            if index % 2:
                yield Box(x - 3.0, top, self.width + 6.0, ROW, STRIPE)
        for place, index in enumerate(rows, 1):
            yield self._row(self.rows[index], x, y + place * ROW)

    def _shift(self, column: int, text: str) -> float:
        """Return how far a text is moved to the right: numbers end at the right end of their column."""
        return self._widths[column] - ROW_TEXT.width(text) if column >= 2 else 0.0

    def _row(self, row: Row, x: float, y: float) -> Group:
        middle = y + ROW / 2
        left = x + row.level * self.indent
        shapes: list[Shape] = list(self._lines(row, x, y))
        fill, outline, letters = FRAME_STYLES["static" if row.state == "loop" else row.state]
        is_loop = row.state == "loop"
        pen = Pen(LOOP if is_loop else outline, 0.8, (2.0, 2.0) if is_loop else ())
        width = ROW_NAME.width(row.cells[0]) + 8.0
        shapes.append(Box(left, y + 1.5, width, ROW - 3.0, fill, pen, 0.0 if is_loop else 2.5))
        shapes.append(
            Text(
                left + 4.0,
                middle + ROW_NAME.size * 0.36,
                row.cells[0],
                ROW_NAME,
                LOOP if is_loop else letters,
            )
        )
        ink = STALE if row.state == "stale" else INK
        for i, text in enumerate(row.cells[1:], 1):
            if text:
                at = x + self._lefts[i] + self._shift(i, text)
                shapes.append(Text(at, middle + ROW_TEXT.size * 0.36, text, ROW_TEXT, ink))
        return Group(shapes, self.tree.description_of(row.frame), row.frame)

    def _lines(self, row: Row, x: float, y: float) -> Iterator[Shape]:
        """Yield the lines of the levels above, and the one to the frame."""
        for level, goes_on in enumerate(row.guides):
            at = x + level * self.indent + min(5.0, self.indent / 2)
            is_own = level == row.level - 1
            if goes_on:
                yield Path([(at, y), (at, y + ROW)], GUIDE)
            elif is_own:
                yield Path([(at, y), (at, y + ROW / 2)], GUIDE)
            if is_own:
                end = x + row.level * self.indent
                pen = line_pen(row.state)
                yield Path(
                    [(at, y + ROW / 2), (end, y + ROW / 2)], pen._replace(dash=DASH if pen.dash else ())
                )


def _rows(tree: FrameTree) -> Iterator[Row]:
    children = tree.children
    stack: list[tuple[str, tuple[bool, ...]]] = [(root, ()) for root in reversed(tree.layout.roots)]
    while stack:
        frame, guides = stack.pop()
        yield Row(frame, len(guides), tree.state_of(frame), _cells(tree, frame), guides)
        below = children[frame]
        for i, child in reversed(list(enumerate(below))):
            stack.append((child, (*guides, i < len(below) - 1)))


def _cells(tree: FrameTree, frame: str) -> tuple[str, ...]:
    name = elided(printable(frame), ROW_NAME, NAME_WIDTH)
    edge = tree.edges.get(frame)
    if edge is None:
        return name, "", "", "", "", ""
    publishers = elided(printable(", ".join(edge.publishers)), ROW_TEXT, PUBLISHER_WIDTH)
    if frame in tree.layout.loop_starts:
        parent = elided(printable(edge.record.parent), ROW_NAME, NAME_WIDTH / 2)
        name = f"{name} (child of {parent})"
    return name, publishers, edge.rate_text, *_times(edge, tree.newest_s)


def _times(edge: DrawnEdge, newest_s: float) -> tuple[str, str, str]:
    record = edge.record
    if record.is_static:
        return "", "", ""
    return (
        f"{record.buffer_length:.2f}",
        f"{record.most_recent - newest_s:.3f}",
        f"{record.oldest - newest_s:.3f}",
    )


def one_page(tree: FrameTree, shape: float = 1.5) -> Picture:
    """Return the table on one page, in as many columns as bring width to height nearest to `shape`."""
    table = Table(tree)
    header = Header(tree, table.width)

    def off(columns: int) -> float:
        width = columns * (table.width + COLUMN_GAP)
        ratio = width / (table.height(-(-len(table.rows) // columns)) + header.height)
        return max(ratio / shape, shape / ratio)

    columns = min(range(1, max(2, len(table.rows) // 20)), key=off)
    length = -(-len(table.rows) // columns)
    starts = [*range(0, len(table.rows), length), len(table.rows)]
    blocks = [range(start, end) for start, end in pairwise(starts)]
    width = max(len(blocks) * table.width + (len(blocks) - 1) * COLUMN_GAP, header.width)
    return _page(table, header, blocks, (width + 2 * MARGIN, 0.0))


def pages(tree: FrameTree, least_size: tuple[float, float]) -> list[Picture]:
    """Return the table on pages of `least_size` (width, height), or wider if the columns need it."""
    table = Table(tree)
    header = Header(tree, table.width)
    width, height = max(least_size[0], max(table.width, header.width) + 2 * MARGIN), least_size[1]
    room = height - 2 * MARGIN - ROW * 2
    first = int((room - header.height - HEADER_GAP) / ROW) - 1
    starts = [0, *range(first, len(table.rows), int(room / ROW) - 1), len(table.rows)]
    blocks = [range(start, end) for start, end in pairwise(starts)]
    return [
        _page(table, None if i else header, [block], (width, height), f"page {i + 1} of {len(blocks)}")
        for i, block in enumerate(blocks)
    ]


def _page(
    table: Table,
    header: Header | None,
    blocks: Sequence[range],
    least_size: tuple[float, float],
    footer: str = "",
) -> Picture:
    """Return one page with blocks of rows beside each other."""
    shapes: list[Shape] = []
    y = MARGIN
    if header is not None:
        shapes += header.shapes(MARGIN, y)
        y += header.height + HEADER_GAP
    for i, block in enumerate(blocks):
        shapes += table.shapes(block, MARGIN + i * (table.width + COLUMN_GAP), y)
    longest = max((len(block) for block in blocks), default=0)
    height = max(least_size[1], y + table.height(longest) + ROW + MARGIN)
    shapes.append(Text(MARGIN, height - MARGIN, NOTE, ROW_TEXT, FAINT))
    if footer:
        left = least_size[0] - MARGIN - ROW_TEXT.width(footer)
        shapes.append(Text(left, height - MARGIN, footer, ROW_TEXT, FAINT))
    return Picture(least_size[0], height, shapes, HEADING)
