"""Title and legend of a drawn tree."""

from __future__ import annotations

from collections.abc import Iterator

from tfloom.common.text import utc_text
from tfloom.tf2_tools.drawing.colors import (
    FAINT,
    FRAME_STYLES,
    INK,
    LINE_COLORS,
    LOOP,
    STATIC_DASH,
    SUBTITLE,
    TEXT,
    TITLE,
)
from tfloom.tf2_tools.drawing.fonts import missing_letters
from tfloom.tf2_tools.drawing.shapes import Box, Path, Pen, Shape, Text
from tfloom.tf2_tools.tree_pictures.records import NO_DATA
from tfloom.tf2_tools.tree_pictures.tree import FrameTree

HEADING = "view_frames Result"
HOW_TO_GET_FONTS = "install one, such as WenQuanYi Micro Hei (fonts-wqy-microhei)"
MARGIN = 28.0
SAMPLE = 20.0
"""Length of a line in the legend."""
SAMPLE_GAP = 5.0
ENTRY_GAP = 16.0
BEFORE_LEGEND = 6.0

LEGEND = {
    "root": "root",
    "live": "moving",
    "static": "static",
    "stale": "stale: older than the others",
    "loop": "loop: its parent is one of its descendants, so no lookup across it can work",
}


def header_lines(tree: FrameTree) -> list[str]:
    """Return the lines below the title."""
    lines = [f"Recorded at time: {tree.recorded_at_s} ({utc_text(tree.recorded_at_s)})", tree.summary()]
    if not tree.edges:
        return [lines[0], NO_DATA]
    if tree.newest_s:
        lines.append(f"Newest transform: {tree.newest_s:.6f} s")
    if missing := missing_note(tree):
        lines.append(missing)
    return lines


def missing_note(tree: FrameTree) -> str:
    """Return a sentence about letters that no font here has; empty if there are none."""
    names = "".join([*tree.frames, *(name for edge in tree.edges.values() for name in edge.publishers)])
    missing = missing_letters(names)
    if not missing:
        return ""
    codes = " ".join(f"U+{ord(letter):04X}" for letter in missing[:4])
    more = f" and {len(missing) - 4} more" if len(missing) > 4 else ""
    return f"No TrueType font here has {codes}{more}, written as escapes: {HOW_TO_GET_FONTS}"


class Header:
    """Title, lines and legend, as wide and as high as they need."""

    def __init__(self, tree: FrameTree, width: float = 0.0) -> None:
        self._lines = header_lines(tree)
        states = {tree.state_of(frame) for frame in tree.frames}
        self._entries = [(state, text) for state, text in LEGEND.items() if state in states]
        lengths = [SAMPLE + SAMPLE_GAP + TEXT.width(text) for _, text in self._entries]
        self.width = max(
            TITLE.width(HEADING), *map(SUBTITLE.width, self._lines), *lengths, min(width, sum(lengths) * 1.3)
        )
        self._rows = list(self._legend_rows(lengths))
        self.height = TITLE.leading + len(self._lines) * SUBTITLE.leading
        if self._rows:
            self.height += BEFORE_LEGEND + len(self._rows) * TEXT.leading * 1.4

    def _legend_rows(self, lengths: list[float]) -> Iterator[list[tuple[float, str, str]]]:
        """Yield the rows of the legend: left end, state and text of each entry."""
        row: list[tuple[float, str, str]] = []
        x = 0.0
        for (state, text), length in zip(self._entries, lengths, strict=True):
            if row and x + length > self.width:
                yield row
                row, x = [], 0.0
            row.append((x, state, text))
            x += length + ENTRY_GAP
        if row:
            yield row

    def shapes(self, x: float, y: float) -> Iterator[Shape]:
        """Yield the header from its upper left corner."""
        yield Text(x, y + TITLE.size, HEADING, TITLE, INK)
        y += TITLE.leading
        for line in self._lines:
            y += SUBTITLE.leading
            yield Text(x, y - SUBTITLE.size * 0.3, line, SUBTITLE, FAINT)
        y += BEFORE_LEGEND
        for row in self._rows:
            y += TEXT.leading * 1.4
            for left, state, text in row:
                yield from _sample(x + left, y - TEXT.size * 0.8, state)
                yield Text(x + left + SAMPLE + SAMPLE_GAP, y - TEXT.size * 0.45, text, TEXT, INK)


def _sample(x: float, y: float, state: str) -> Iterator[Shape]:
    """Yield a short line to a small box, as they are drawn for frames in a state."""
    fill, outline, _ = FRAME_STYLES[state]
    if state != "root":
        yield Path([(x, y), (x + SAMPLE - 9.0, y)], line_pen(state))
    pen = Pen(outline, 0.8, (2.0, 2.0) if outline == LOOP else ())
    yield Box(x + SAMPLE - 9.0, y - 3.0, 9.0, 6.0, fill, pen, 0.0 if pen.dash else 1.5)


def line_pen(state: str) -> Pen:
    """Return the pen for the line from a parent to a frame in a state."""
    return Pen(LINE_COLORS[state], 1.0, STATIC_DASH if state == "static" else ())
