"""A distance that a page measures between two places of the scene."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.viser_private import HAS_PIXEL_POINTS, pixel_size

if TYPE_CHECKING:
    from viser import SceneApi

    from tfloom.viewer.layout.layout import Point

__all__ = ["Measure", "Place"]

COLOR = (80, 230, 255)
POINT_PX = 9.0
POINT_M = 0.05
"""Size of an end where points can't have a size in pixels [m]."""


class Place(NamedTuple):
    """A place of the scene."""

    point: Point
    """In the fixed frame [m]."""
    name: str
    """Of what is there."""


class Measure:
    """Up to two places, with the line between them in a page's own scene.

    The places stay where they are, whatever moves there.

    Args:
        scene: The page's own scene.
        frame: The fixed frame, in which the places are.
    """

    def __init__(self, scene: SceneApi, frame: str) -> None:
        self.scene = scene
        self.frame = frame
        self.places: list[Place] = []
        self._nodes: list[Any] = []

    def add(self, place: Place) -> str:
        """Add a place; return what is measured, as a sentence. A third one clears both, and isn't added."""
        if len(self.places) == 2:
            self.clear()
            return ""
        self.places.append(place)
        self._draw()
        if len(self.places) == 1:
            return f"from {shown_text(place.name)}: click on where to measure to"
        return self.text

    @property
    def distance_m(self) -> float:
        """The distance of the places [m]; 0 with fewer than two."""
        return math.dist(*(place.point for place in self.places)) if len(self.places) == 2 else 0.0

    @property
    def text(self) -> str:
        """What is measured; empty with fewer than two places."""
        if len(self.places) < 2:
            return ""
        first, second = self.places
        dx, dy, dz = (
            round(end - start, 3) + 0.0 for start, end in zip(first.point, second.point, strict=True)
        )
        ends = f"from {shown_text(first.name)} to {shown_text(second.name)}"
        return f"{self.distance_m:.3f} m {ends}: dx {dx:.3f}, dy {dy:.3f}, dz {dz:.3f} m in {shown_text(self.frame)}"

    def clear(self) -> None:
        """Take the places and the line away; others may be added."""
        self.places.clear()
        for node in self._nodes:
            node.remove()
        self._nodes.clear()

    def _draw(self) -> None:
        for node in self._nodes:
            node.remove()
        points = np.array([place.point for place in self.places], np.float32)
        colors = np.tile(np.array(COLOR, np.uint8), (len(points), 1))
        size = pixel_size(POINT_PX) if HAS_PIXEL_POINTS else POINT_M
        self._nodes = [
            self.scene.add_point_cloud("/measure/ends", points, colors, point_size=size, point_shape="circle")
        ]
        if len(points) == 2:
            line = points[np.newaxis]
            self._nodes += [
                self.scene.add_line_segments(
                    "/measure/line", line, np.array(COLOR, np.uint8), thickness=3.0, thickness_units="screen"
                ),
                self.scene.add_label(
                    "/measure/text",
                    f"{self.distance_m:.3f} m",
                    position=points.mean(axis=0),
                    anchor="bottom-center",
                ),
            ]
