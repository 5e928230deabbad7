"""What a picture consists of. Sizes are in points of 1/72 inch; y grows downwards from the upper left corner."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from tfloom.tf2_tools.drawing.fonts import Font

Point: TypeAlias = tuple[float, float]


class Pen(NamedTuple):
    """How a line is drawn."""

    color: str
    """As `#rrggbb`."""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    """Lengths of dashes and gaps in turn; empty for a solid line."""


class Box(NamedTuple):
    """A rectangle, with rounded corners if `radius` is not 0."""

    x: float
    y: float
    width: float
    height: float
    fill: str | None = None
    pen: Pen | None = None
    radius: float = 0.0


class Path(NamedTuple):
    """Straight lines from point to point: open with a pen, or a filled polygon."""

    points: Sequence[Point]
    pen: Pen | None = None
    fill: str | None = None


class Curve(NamedTuple):
    """A cubic Bézier curve, from `points[0]` to `points[3]`."""

    points: tuple[Point, Point, Point, Point]
    pen: Pen


class Text(NamedTuple):
    """One line of text, from the left end of its baseline."""

    x: float
    y: float
    text: str
    font: Font
    color: str


class Group(NamedTuple):
    """Shapes that are one thing; formats that can show its description when it is pointed at."""

    shapes: list[Shape]
    title: str = ""
    """Description of several lines."""
    name: str = ""
    """What the group stands for, as the id of a frame; scripts find the group by it."""


Shape: TypeAlias = "Box | Path | Curve | Text | Group"


class Picture(NamedTuple):
    """Shapes on a page, which each format draws alike [points]."""

    width: float
    height: float
    shapes: list[Shape]
    title: str
