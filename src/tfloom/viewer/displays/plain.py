"""Displays without a topic: the axes of a frame, and a grid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.viewer.displays.solids import axes_shapes, line_shape
from tfloom.viewer.shapes import Placed, Shape

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

__all__ = ["AxesDisplay", "GridDisplay"]


class PlainDisplay:
    """Shows the same shapes at all times, in the frame of its settings; without one in the fixed frame.

    Args:
        settings: A value for each setting; it may change.
    """

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self, settings: Values) -> None:
        self.settings = settings
        self._made: tuple[dict[str, Any], list[Placed]] = {}, []

    def take(self, message: Any, stamp_ns: int) -> None:
        """Do nothing: there are no messages."""

    def clear(self) -> None:
        """Do nothing: there are no messages."""

    def shapes(self, now_ns: int) -> list[Placed]:
        """Return the shapes, the same ones as long as the settings are."""
        if self._made[0] != self.settings:
            placed = [Placed(shape, self.settings["frame"]) for shape in self.made()]
            self._made = dict(self.settings), placed
        return self._made[1]

    def made(self) -> list[Shape]:
        """Return the shapes, in their frame."""
        raise NotImplementedError


class AxesDisplay(PlainDisplay):
    """Shows the axes of a frame."""

    def made(self) -> list[Shape]:
        """Return the axes."""
        settings = self.settings
        place, turn = [(0.0, 0.0, 0.0)], [(0.0, 0.0, 0.0, 1.0)]
        return axes_shapes(place, turn, settings["length"], settings["radius"], settings["opacity"])


class GridDisplay(PlainDisplay):
    """Shows a grid in a plane of a frame."""

    def made(self) -> list[Shape]:
        """Return its lines."""
        settings = self.settings
        count, size = settings["cells"], settings["size"]
        places = size * (np.arange(count + 1) - count / 2.0)
        reach = np.tile((places[0], places[-1]), (count + 1, 1))
        across = np.stack([np.repeat(places[:, np.newaxis], 2, axis=1), reach], axis=2)
        lines = np.concatenate([across, across[..., ::-1]])
        ends = np.zeros((len(lines), 2, 3))
        ends[..., ["xyz".index(axis) for axis in settings["plane"]]] = lines
        ends += (settings["x"], settings["y"], settings["z"])
        width = settings["width"] if settings["line"] == "wide" else None
        return [line_shape(ends.astype(np.float32), settings["color"], settings["opacity"], width)]
