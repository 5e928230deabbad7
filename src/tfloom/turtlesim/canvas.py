"""The picture of the turtles' world: pen strokes, with turtles on top. Used by window, recordings and notebooks."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.turtlesim.art import sprite
from tfloom.turtlesim.picture import Box, Ink, Picture, plain, to_png
from tfloom.turtlesim.world import PX_PER_M, WINDOW_PX, WORLD_SIZE_M, Color, Stroke, Turtle

FINENESS = 4
"""Resolution of the stored strokes, as a multiple of the original picture's, so that larger pictures are sharp."""
FINE_PX = WINDOW_PX * FINENESS
NOTHING_DRAWN: Color = (255, 255, 255)
"""The colour sensor's value where there is no stroke, for any background."""
DEFAULT_BACKGROUND: Color = (0x45, 0x56, 0xFF)


class Canvas:
    """Stores the strokes, and renders pictures of them with turtles on top.

    Args:
        background: Background colour.
    """

    def __init__(self, background: Color = DEFAULT_BACKGROUND) -> None:
        self.background = background
        self.changes = 0
        """A number that grows with each change of the strokes."""
        self._ink: Ink | None = None
        """The strokes; None before the first one, because so large a picture takes time and memory."""
        self._ground: Picture | None = None
        self._ground_color = background
        self._changed: Box | None = None

    def clear(self) -> None:
        """Remove all strokes, so that the background alone is left."""
        self.changes += 1
        self._ink = None
        self._ground = None

    def paint(self, stroke: Stroke) -> None:
        """Draw a stroke with round ends."""
        self.changes += 1
        ends = [_fine(*stroke.start), _fine(*stroke.end)]
        width = stroke.width_px * FINENESS
        if self._ink is None:
            self._ink = Ink(FINE_PX)
        self._ink.line(ends, stroke.color, width)
        self._touch(ends, width / 2)

    def _touch(self, ends: list[tuple[float, float]], radius: float) -> None:
        """Extend the part of the ink that has changed."""
        (x0, y0), (x1, y1) = ends
        low, high = min(x0, x1) - radius - 1, max(x0, x1) + radius + 1
        top, bottom = min(y0, y1) - radius - 1, max(y0, y1) + radius + 1
        if self._changed is not None:
            low, top = min(low, self._changed[0]), min(top, self._changed[1])
            high, bottom = max(high, self._changed[2]), max(bottom, self._changed[3])
        self._changed = int(low), int(top), int(high) + 1, int(bottom) + 1

    def color_at(self, x: float, y: float) -> Color:
        """Return the colour of the strokes at a point [m]; white where there is none."""
        if self._ink is None:
            return NOTHING_DRAWN
        px, py = (min(max(int(value), 0), FINE_PX - 1) for value in _fine(x, y))
        return self._ink.color_at(px, py) or NOTHING_DRAWN

    def render(self, turtles: Iterable[Turtle], size_px: int = WINDOW_PX) -> Picture:
        """Return an RGB picture of `size_px` by `size_px`, the turtles in order of their names."""
        picture = self._ground_at(size_px).copy()
        scale = size_px / WINDOW_PX
        for turtle in sorted(turtles, key=lambda one: one.name):
            image = sprite(turtle.kind, turtle.theta, PX_PER_M * scale)
            x, y = (value * scale / FINENESS - image.width / 2 for value in _fine(turtle.x, turtle.y))
            picture.paste(image, (round(x), round(y)), image)
        return picture

    def _repr_png_(self) -> bytes:
        """Show the strokes in a notebook."""
        return self.png(())

    def png(self, turtles: Iterable[Turtle], size_px: int = WINDOW_PX) -> bytes:
        """Return the picture as a PNG file's bytes."""
        return to_png(self.render(turtles, size_px))

    def _ground_at(self, size_px: int) -> Picture:
        """Return background and strokes in this size; only the changed part is scaled anew."""
        ground, changed = self._ground, self._changed
        self._changed = None
        if ground is None or ground.width != size_px or self._ground_color != self.background:
            ground = self._ground = plain(size_px, self.background)
            self._ground_color = self.background
            changed = (0, 0, FINE_PX, FINE_PX)
        if changed is not None and self._ink is not None:
            self._lay_ink(self._ink, ground, changed)
        return ground

    def _lay_ink(self, ink: Ink, ground: Picture, part: Box) -> None:
        """Lay the ink within `part`, in the ink's pixels, onto `ground`."""
        ratio = FINE_PX / ground.width
        left, top = (max(0, int(edge / ratio) - 1) for edge in part[:2])
        right, bottom = (min(ground.width, int(edge / ratio) + 2) for edge in part[2:])
        if left < right and top < bottom:
            ink.lay_onto(ground, (left, top, right, bottom), self.background)


def _fine(x: float, y: float) -> tuple[float, float]:
    """Return the ink's pixel at a point [m]."""
    return x * PX_PER_M * FINENESS, (WORLD_SIZE_M - y) * PX_PER_M * FINENESS
