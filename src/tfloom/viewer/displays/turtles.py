"""turtlesim's world: a floor, and a turtle on it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.turtlesim.art import LOOKS, sprite
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND
from tfloom.turtlesim.world import WORLD_SIZE_M
from tfloom.viewer.displays.display import Latest
from tfloom.viewer.shapes import DisplayError, Picture, Placed

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

__all__ = ["WORLD_FRAME", "TurtleDisplay"]

WORLD_FRAME = "world"
"""The frame in which turtles are, as the broadcasters of the tutorials name it."""
TURTLE_PX = 128
"""Length of a turtle in its picture."""
WATER_M = 0.005
TURTLE_M = 0.02
"""Heights of water and turtle above the floor, so that one hides the other [m]."""


class TurtleDisplay(Latest):
    """Shows the last `turtlesim/msg/Pose`, and the water that all turtles share; what is not finite is an error."""

    def __init__(self, settings: Values, topic: str = "") -> None:
        super().__init__(settings)
        # The same name has the same look each time; turtlesim itself chooses by chance.
        self._kind = sum(topic.encode("utf-8", "replace")) % len(LOOKS)
        self._pictures: tuple[Picture, Picture] | None = None

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return water and turtle.

        Raises:
            DisplayError: a number is not finite.
        """
        x, y, theta = float(message.x), float(message.y), float(message.theta)
        if not all(map(math.isfinite, (x, y, theta))):
            raise DisplayError("a number of its pose is not finite")
        water, turtle = self._made_pictures()
        # A picture begins at its corner, and the pose is that of the turtle's middle.
        pose = Transform.from_rpy(0.0, 0.0, theta, (x, y, TURTLE_M))
        half = turtle.size[0] / 2.0
        corner = pose.apply((-half, -half, 0.0))
        return [
            Placed(water, WORLD_FRAME, position=(0.0, 0.0, WATER_M)),
            Placed(turtle, WORLD_FRAME, position=corner, rotation_xyzw=pose.rotation_xyzw),
        ]

    def _made_pictures(self) -> tuple[Picture, Picture]:
        """Return the water and the turtle, made once: the page keeps pictures that stay the same."""
        if self._pictures is None:
            water = np.full((1, 1, 3), DEFAULT_BACKGROUND, np.uint8)
            turtle = np.asarray(sprite(self._kind, 0.0, TURTLE_PX))
            size_m = len(turtle) / TURTLE_PX
            sides = (WORLD_SIZE_M, WORLD_SIZE_M), (size_m, size_m)
            self._pictures = Picture(water, sides[0]), Picture(turtle, sides[1])
        return self._pictures
