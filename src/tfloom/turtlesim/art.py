"""Ten turtles, drawn from above: shapes in a turtle's coordinates, painted in any size and direction.

A turtle is one unit long, heads along x and is symmetric about it; y is to its left.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

from tfloom.turtlesim.picture import Color, Ink, Picture, Point

SMOOTHING = 4
"""Oversampling factor of a turtle's picture, for smooth edges."""
HEADINGS = 180
"""Number of headings with a sprite: one every two degrees."""
OUTLINE: Color = (38, 43, 40)


class Look(NamedTuple):
    """Colours and shell pattern of a kind of turtle."""

    skin: Color
    shell: Color
    marks: Color
    pattern: str


LOOKS = (
    Look((122, 176, 92), (86, 125, 70), (150, 190, 110), "scutes"),
    Look((214, 176, 118), (139, 90, 43), (205, 150, 80), "rings"),
    Look((118, 196, 190), (24, 110, 120), (150, 225, 215), "rays"),
    Look((236, 190, 190), (190, 62, 72), (250, 214, 200), "spots"),
    Look((186, 160, 214), (98, 66, 150), (200, 175, 235), "scutes"),
    Look((240, 206, 120), (214, 130, 26), (255, 226, 150), "stripes"),
    Look((170, 184, 196), (74, 88, 104), (190, 205, 215), "rings"),
    Look((150, 200, 240), (40, 92, 170), (180, 218, 250), "spots"),
    Look((226, 226, 214), (148, 148, 128), (96, 98, 84), "rays"),
    Look((250, 178, 206), (206, 80, 140), (255, 206, 226), "stripes"),
)


class Shape(NamedTuple):
    """A filled polygon."""

    points: list[Point]
    fill: Color


def _ellipse(x: float, y: float, along: float, across: float, turn_rad: float = 0.0) -> list[Point]:
    cos, sin = math.cos(turn_rad), math.sin(turn_rad)
    angles = (2 * math.pi * i / 40 for i in range(40))
    return [
        (
            x + cos * along * math.cos(a) - sin * across * math.sin(a),
            y + sin * along * math.cos(a) + cos * across * math.sin(a),
        )
        for a in angles
    ]


def _mirrored(points: Iterable[Point]) -> list[Point]:
    return [(x, -y) for x, y in points]


def _outlined(points: list[Point], fill: Color, rim: float = 0.02) -> Iterator[Shape]:
    """Yield a shape with a dark rim: below it, the same shape scaled up about its centre."""
    x = sum(point[0] for point in points) / len(points)
    y = sum(point[1] for point in points) / len(points)
    grown = []
    for point in points:
        length = math.hypot(point[0] - x, point[1] - y) or 1.0
        factor = 1 + rim / length
        grown.append((x + (point[0] - x) * factor, y + (point[1] - y) * factor))
    yield Shape(grown, OUTLINE)
    yield Shape(points, fill)


SHELL = (-0.03, 0.0, 0.31, 0.26)
"""Centre and half axes of the shell."""


def turtle_shapes(look: Look) -> Iterator[Shape]:
    """Yield a turtle's shapes, from the lowest to the uppermost."""
    yield from _outlined([(-0.31, 0.05), (-0.31, -0.05), (-0.47, 0.0)], look.skin)
    front, rear = _ellipse(0.19, 0.28, 0.17, 0.075, 1.0), _ellipse(-0.25, 0.23, 0.13, 0.065, 2.4)
    for limb in (front, rear, _mirrored(front), _mirrored(rear)):
        yield from _outlined(limb, look.skin)
    yield from _outlined(_ellipse(0.37, 0.0, 0.13, 0.105), look.skin)
    for side in (1, -1):
        yield Shape(_ellipse(0.415, side * 0.062, 0.03, 0.026), (250, 250, 245))
        yield Shape(_ellipse(0.423, side * 0.064, 0.017, 0.016), OUTLINE)
    yield from _outlined(_ellipse(*SHELL), look.shell)
    for points in PATTERNS[look.pattern]:
        yield Shape(points, look.marks)


def _scutes() -> Iterator[list[Point]]:
    x, y, _, _ = SHELL
    for centre, radius in [((x, y), 0.088)] + [
        ((x + 0.185 * math.cos(a) * 1.08, y + 0.155 * math.sin(a) * 1.05), 0.064)
        for a in (math.pi / 3 * i for i in range(6))
    ]:
        yield [
            (centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a))
            for a in (math.pi / 3 * i + math.pi / 6 for i in range(6))
        ]


def _rings() -> Iterator[list[Point]]:
    x, y, along, across = SHELL
    for outer, inner in ((0.84, 0.66), (0.48, 0.28)):
        yield [
            *_ellipse(x, y, along * outer, across * outer),
            (x + along * outer, y),
            *reversed(_ellipse(x, y, along * inner, across * inner)),
            (x + along * inner * math.cos(0.157), y - across * inner * math.sin(0.157)),
        ]


def _rays() -> Iterator[list[Point]]:
    x, y, along, across = SHELL
    for i in range(9):
        a = 2 * math.pi * i / 9
        yield [
            (x + 0.14 * along * math.cos(a), y + 0.14 * across * math.sin(a)),
            (x + 0.86 * along * math.cos(a - 0.17), y + 0.86 * across * math.sin(a - 0.17)),
            (x + 0.86 * along * math.cos(a + 0.17), y + 0.86 * across * math.sin(a + 0.17)),
        ]


def _spots() -> Iterator[list[Point]]:
    x, y, _, _ = SHELL
    for dx, dy, radius in (
        (0.0, 0.0, 0.07),
        (0.17, 0.07, 0.045),
        (0.15, -0.1, 0.04),
        (-0.16, 0.1, 0.05),
        (-0.19, -0.06, 0.042),
        (0.01, 0.165, 0.042),
        (-0.01, -0.165, 0.046),
    ):
        yield _ellipse(x + dx, y + dy, radius, radius)


def _stripes() -> Iterator[list[Point]]:
    x, y, along, across = SHELL
    for middle in (-0.6, -0.2, 0.2, 0.6):
        near, far = middle - 0.09, middle + 0.09
        side_near, side_far = (0.9 * math.sqrt(1 - edge * edge) for edge in (near, far))
        yield [
            (x + along * near, y - across * side_near),
            (x + along * near, y + across * side_near),
            (x + along * far, y + across * side_far),
            (x + along * far, y - across * side_far),
        ]


PATTERNS = {
    "scutes": list(_scutes()),
    "rings": list(_rings()),
    "rays": list(_rays()),
    "spots": list(_spots()),
    "stripes": list(_stripes()),
}


def sprite(kind: int, theta_rad: float, length_px: float) -> Picture:
    """Return a square picture of a turtle on a transparent background, with the turtle's origin at its centre.

    Args:
        kind: Index into `LOOKS`, modulo its length.
        theta_rad: Its heading, counter-clockwise from the right; rounded to two degrees.
        length_px: Its length.
    """
    heading = round(theta_rad / (2 * math.pi) * HEADINGS) % HEADINGS
    return _sprite(kind % len(LOOKS), heading, round(length_px))


@lru_cache(maxsize=2000)
def _sprite(kind: int, heading: int, length_px: int) -> Picture:
    theta = 2 * math.pi * heading / HEADINGS
    cos, sin = math.cos(theta), math.sin(theta)
    side = max(2, round(1.1 * length_px))
    fine = side * SMOOTHING
    scale = length_px * SMOOTHING
    ink = Ink(fine)
    for shape in turtle_shapes(LOOKS[kind]):
        points = [
            (fine / 2 + scale * (cos * x - sin * y), fine / 2 - scale * (sin * x + cos * y))
            for x, y in shape.points
        ]
        ink.polygon(points, shape.fill)
    return ink.reduced_picture(SMOOTHING)
