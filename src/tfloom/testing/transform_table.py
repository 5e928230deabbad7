"""Transforms as a text, for tests: a line of column names, and a line for each transform.

    frame_id  child_frame_id  stamp   x    y    z    yaw_deg
    map       odom            static  0.5  0    0    0
    odom      base            1.0     0    0    0    0
    odom      base            2.0     1    0    0    90

`stamp` is in seconds, or `static`; without the column, all are static. Numbers that are not given are 0: `x`, `y`, `z`
[m]; `roll`, `pitch`, `yaw` [rad] or `roll_deg`, `pitch_deg`, `yaw_deg`, about fixed axes; or `qx`, `qy`, `qz`, `qw`.
Empty lines, lines of dashes and what follows a `#` are ignored, and `|` may separate columns.
"""

from __future__ import annotations

import math
from decimal import Decimal, InvalidOperation
from typing import TYPE_CHECKING, NamedTuple

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2.transform import Transform

if TYPE_CHECKING:
    from tfloom.tf2_ros.buffer import Buffer

__all__ = ["Row", "TableError", "buffer_of", "messages_of", "read_table"]

__tracebackhide__ = True  # pytest shows an error where the test gives the table

FRAMES = ("frame_id", "child_frame_id")
POSITION = ("x", "y", "z")
ANGLES = ("roll", "pitch", "yaw")
QUATERNION = ("qx", "qy", "qz", "qw")
DEGREES = tuple(f"{name}_deg" for name in ANGLES)
KNOWN = {*FRAMES, "stamp", *POSITION, *ANGLES, *DEGREES, *QUATERNION}
STATIC = "static"
SECOND = 1_000_000_000
MIN_CACHE_NS = 10 * SECOND


class TableError(ValueError):
    """A table of transforms is malformed; the text has the line, the column and what is expected."""


class Row(NamedTuple):
    """One transform of a table."""

    frame_id: str
    child_frame_id: str
    stamp_ns: int | None
    """None: static."""
    parent_from_child: Transform


def read_table(text: str) -> list[Row]:
    """Return the transforms of a table, in its order.

    Raises:
        TableError: it is malformed, or has no transform.
    """
    if not isinstance(text, str):
        raise TableError(f"a table is a text with a line of column names, not {type(text).__name__}")
    columns: list[str] = []
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        cells = line.partition("#")[0].replace("|", " ").split()
        if not "".join(cells).strip("-:"):
            continue
        if columns:
            rows.append(_row(number, columns, cells))
        else:
            columns = _columns(number, cells)
    if not rows:
        raise TableError(
            "the table has no transform: it needs a line of column names, and a line for each transform"
        )
    return rows


def _columns(number: int, names: list[str]) -> list[str]:
    if missing := [name for name in FRAMES if name not in names]:
        raise TableError(
            f"line {number} of the table must name the columns, among them {' and '.join(missing)}: {' '.join(names)}"
        )
    if unknown := [name for name in names if name not in KNOWN]:
        raise TableError(
            f"line {number} of the table: no column is called {unknown[0]}, only {', '.join(sorted(KNOWN))}"
        )
    if len(set(names)) < len(names):
        raise TableError(f"line {number} of the table names a column twice: {' '.join(names)}")
    kinds = [kind for kind in (ANGLES, DEGREES, QUATERNION) if set(kind) & set(names)]
    if len(kinds) > 1:
        raise TableError(
            f"line {number} of the table: choose one of {' and '.join(kind[-1] for kind in kinds)}"
        )
    if kinds == [QUATERNION] and not set(QUATERNION) <= set(names):
        raise TableError(f"line {number} of the table: a quaternion needs all of {', '.join(QUATERNION)}")
    return names


def _row(number: int, columns: list[str], cells: list[str]) -> Row:
    if len(cells) != len(columns):
        raise TableError(
            f"line {number} of the table has {len(cells)} cells for {len(columns)} columns: {' '.join(cells)}"
        )
    cell_of = dict(zip(columns, cells, strict=True))
    frame_id, child_frame_id = (cell_of[name] for name in FRAMES)
    if frame_id == child_frame_id:
        raise TableError(f"line {number} of the table: {frame_id} can't be its own parent")

    def number_in(name: str) -> float:
        return _finite(number, name, cell_of.get(name, "0"))

    position = (number_in("x"), number_in("y"), number_in("z"))
    try:
        if "qw" in cell_of:
            qx, qy, qz, qw = (number_in(name) for name in QUATERNION)
            transform = Transform(position, (qx, qy, qz, qw))
        else:
            roll, pitch, yaw = (number_in(name) + math.radians(number_in(f"{name}_deg")) for name in ANGLES)
            transform = Transform.from_rpy(roll, pitch, yaw, position)
    except ValueError as error:
        raise TableError(f"line {number} of the table: {error}") from None
    return Row(frame_id, child_frame_id, _stamp(number, cell_of.get("stamp", STATIC)), transform)


def _finite(number: int, column: str, cell: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise TableError(f"line {number} of the table: {column} is {cell}, which is not a finite number")
    return value


def _stamp(number: int, cell: str) -> int | None:
    if cell == STATIC:
        return None
    try:
        stamp_ns = int(Decimal(cell) * SECOND)
    except (InvalidOperation, ValueError, OverflowError):
        stamp_ns = 0
    if not 0 < stamp_ns < 2**31 * SECOND:
        raise TableError(f"line {number} of the table: stamp is {cell}, neither seconds above 0 nor {STATIC}")
    return stamp_ns


def messages_of(rows: list[Row], *, static: bool) -> list[TransformStamped]:
    """Return the static transforms, or the others, as messages."""
    return [_message(row) for row in rows if (row.stamp_ns is None) == static]


def _message(row: Row) -> TransformStamped:
    message = TransformStamped(child_frame_id=row.child_frame_id)
    message.header.frame_id = row.frame_id
    message.header.stamp = Time(nanoseconds=row.stamp_ns or 0).to_msg()
    position, rotation = message.transform.translation, message.transform.rotation
    position.x, position.y, position.z = row.parent_from_child.translation
    rotation.x, rotation.y, rotation.z, rotation.w = row.parent_from_child.rotation_xyzw
    return message


def buffer_of(text: str) -> Buffer:
    """Return a buffer that holds all transforms of a table, whose history is as long as they need, at least 10 s.

    Raises:
        TableError: the table is malformed.
    """
    from tfloom.tf2_ros.buffer import Buffer

    rows = read_table(text)
    stamps = [row.stamp_ns for row in rows if row.stamp_ns is not None]
    span_ns = max(stamps) - min(stamps) if stamps else 0
    buffer = Buffer(Duration(nanoseconds=max(MIN_CACHE_NS, span_ns + SECOND)))
    for message in messages_of(rows, static=True):
        buffer.set_transform_static(message, "table")
    for message in messages_of(rows, static=False):
        buffer.set_transform(message, "table")
    return buffer
