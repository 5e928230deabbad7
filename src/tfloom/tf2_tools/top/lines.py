"""The table, and the transform between two frames, as lines of text, for a terminal of any width, or for a file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from rich.cells import cell_len, set_cell_size

from tfloom.common.terminal import shown_name
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException
from tfloom.tf2_tools.text import counted, matrix_from_quaternion, rpy_from_matrix
from tfloom.tf2_tools.top.rows import Health, Row
from tfloom.tf2_tools.top.view import HELP, View

HEADINGS = ("FRAME", "RATE", "AGE", "DELAY", "PUBLISHER", "NOTE")
RATE_WIDTH, AGE_WIDTH, DELAY_WIDTH = 9, 9, 9
MAX_PREFIX_WIDTH = 40
"""Columns that a tree's branches may take."""
MIN_FRAME_WIDTH, MIN_PUBLISHER_WIDTH = 16, 10
STYLES = {
    Health.ROOT: "bold",
    Health.STATIC: "cyan",
    Health.OK: "green",
    Health.LATE: "yellow",
    Health.STALE: "bright_black",
    Health.BAD: "bold red",
}
TITLE = "bold"
HEADING = "bold reverse"
SELECTED = "reverse"
FAINT = "bright_black"


class Line(NamedTuple):
    """A line of one style."""

    text: str
    style: str = ""


class Summary(NamedTuple):
    """What the first line says."""

    frames: int
    publishers: int
    rate_hz: float
    """Of all transforms."""
    place: str
    """Where the transforms come from."""


def screen(
    rows: Sequence[Row], summary: Summary, view: View, followed: Sequence[str], size: tuple[int, int]
) -> list[Line]:
    """Return the lines of a terminal of `size` (columns, lines), all of them as wide."""
    columns, height = size
    shown = view.arrange(rows)
    panel = [Line(text, TITLE if i == 0 else "") for i, text in enumerate(followed)]
    # Three lines are taken: the title, the headings, and the help or the prompt at the bottom.
    window = view.window(height - 3 - len(panel))
    widths = _widths(shown, columns)
    lines = [Line(title(rows, summary, view, len(shown)), TITLE), Line(headings(widths), HEADING)]
    for index in window:
        row = shown[index]
        style = STYLES[row.health]
        lines.append(Line(line(row, widths), f"{style} {SELECTED}" if index == view.selected else style))
    lines += [Line("")] * (height - 1 - len(panel) - len(lines))
    lines += [*panel, Line(view.prompt or HELP, TITLE if view.prompt else FAINT)]
    return [Line(set_cell_size(shown_line.text, columns), shown_line.style) for shown_line in lines[:height]]


def table(rows: Sequence[Row], summary: Summary, view: View) -> list[str]:
    """Return the whole table for a file, as wide as it needs."""
    shown = view.arrange(rows)
    widths = _widths(shown, None)
    texts = [title(rows, summary, view, len(shown)), headings(widths), *(line(row, widths) for row in shown)]
    return [text.rstrip() for text in texts]


def title(rows: Sequence[Row], summary: Summary, view: View, shown: int) -> str:
    """Return the first line."""
    edges = sum(row.health is not Health.ROOT for row in rows)
    bad = sum(row.health >= Health.LATE for row in rows)
    counts = [
        counted(summary.frames, "frame"),
        counted(edges, "edge"),
        counted(summary.publishers, "publisher"),
    ]
    parts = [
        f"{summary.place}: {', '.join(counts)}",
        f"{summary.rate_hz:.0f} transforms/s",
        f"{bad} faulty" if bad else "no faults" if rows else "no transforms yet",
    ]
    if view.sort != "tree" or view.is_reversed:
        parts.append(f"by {view.sort}{', reversed' if view.is_reversed else ''}")
    if view.words:
        parts.append(f"filter {view.words!r}: {shown}")
    if view.is_paused:
        parts.append("paused")
    return "  ".join(parts)


def headings(widths: tuple[int, int]) -> str:
    """Return the line of headings."""
    frame, rate, age, delay, publisher, note = HEADINGS
    return _joined_columns(frame, (f"{rate} Hz", f"{age} s", f"{delay} ms"), publisher, note, widths)


def line(row: Row, widths: tuple[int, int]) -> str:
    """Return a row's line."""
    if row.age_s is None or row.delay_s is None:
        numbers = "static" if row.health is not Health.ROOT else "", "", ""
    else:
        numbers = _number(row.rate_hz, 1), _number(row.age_s, 3), _number(row.delay_s * 1e3, 1)
    return _joined_columns(_frame(row), numbers, shown_name(row.publisher), row.note, widths)


def _frame(row: Row) -> str:
    """Return a frame's name: in a tree with the nearest branches, elsewhere with its parent."""
    if not row.prefix and row.parent:
        return f"{shown_name(row.child)} ({shown_name(row.parent)})"
    prefix = row.prefix if len(row.prefix) <= MAX_PREFIX_WIDTH else "…" + row.prefix[-MAX_PREFIX_WIDTH:]
    return prefix + shown_name(row.child)


def _joined_columns(
    frame: str, numbers: tuple[str, str, str], publisher: str, note: str, widths: tuple[int, int]
) -> str:
    rate, age, delay = numbers
    return " ".join(
        [
            _fitted_text(frame, widths[0]),
            rate.rjust(RATE_WIDTH),
            age.rjust(AGE_WIDTH),
            delay.rjust(DELAY_WIDTH),
            _fitted_text(publisher, widths[1]),
            note,
        ]
    )


def _widths(rows: Sequence[Row], columns: int | None) -> tuple[int, int]:
    """Return the widths of the columns of frames and publishers."""
    frame = max([len(HEADINGS[0]), *(cell_len(_frame(row)) for row in rows)])
    publisher = max([len(HEADINGS[4]), *(cell_len(shown_name(row.publisher)) for row in rows)])
    if columns is None:
        return frame, publisher
    note = max([len(HEADINGS[5]), *(cell_len(row.note) for row in rows)])
    # The numbers have fixed widths, and the note gets up to a quarter of the line. What is left is for the two names:
    # the publisher gives way first, down to a third, because rows are told apart by their frames.
    blanks = len(HEADINGS) - 1
    room = columns - RATE_WIDTH - AGE_WIDTH - DELAY_WIDTH - blanks - min(note, columns // 4)
    if frame + publisher <= room:
        return frame, publisher
    publisher = max(MIN_PUBLISHER_WIDTH, min(publisher, room // 3))
    return max(MIN_FRAME_WIDTH, min(frame, room - publisher)), publisher


def _fitted_text(text: str, width: int) -> str:
    """Return a text as wide as `width`: with blanks, or with its end cut off and `…`."""
    if cell_len(text) <= width:
        return set_cell_size(text, width)
    return set_cell_size(text, width - 1) + "…"


def _number(value: float, digits: int) -> str:
    """Return a number that fits into its column."""
    text = f"{value:.{digits}f}"
    return text if len(text) <= RATE_WIDTH else f"{value:.0e}"


def follow_lines(buffer: Buffer, pair: tuple[str, str], now_ns: int) -> list[str]:
    """Return the newest transform that takes data from the source into the target frame, or why there is none.

    Args:
        buffer: The buffer with both frames.
        pair: Target and source frame.
        now_ns: The time with which its stamp is compared [ns since epoch].
    """
    target, source = pair
    heading = f"{shown_name(target)} from {shown_name(source)}"
    try:
        transform = buffer.lookup(target, source)
    except TransformException as error:
        return [heading, f"  {shown_name(str(error).splitlines()[0])}", ""]
    x, y, z = transform.translation
    angles = rpy_from_matrix(matrix_from_quaternion(transform.rotation_xyzw))
    roll, pitch, yaw = (round(math.degrees(angle), 2) + 0.0 for angle in angles)  # no -0.00
    age = f"age {(now_ns - transform.stamp_ns) / 1e9:.3f} s" if transform.stamp_ns else "static"
    return [
        f"{heading}  {age}",
        f"  translation [m]    x {x:+9.3f}  y {y:+9.3f}  z {z:+9.3f}   distance {math.hypot(x, y, z):.3f}",
        f"  rotation   [deg]   roll {roll:+8.2f}  pitch {pitch:+8.2f}  yaw {yaw:+8.2f}",
    ]
