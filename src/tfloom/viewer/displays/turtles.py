"""turtlesim's world: a floor, and a turtle on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.turtlesim.art import LOOKS, sprite
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND
from tfloom.turtlesim.world import WORLD_SIZE_M
from tfloom.viewer.shapes import DisplayError, Picture, Placed

__all__ = ["WORLD_FRAME", "TurtleDisplay"]

WORLD_FRAME = "world"
"""The frame in which turtles are, as the broadcasters of the tutorials name it."""
TURTLE_PX = 128
"""Length of a turtle in its picture."""
WATER_M = 0.005
TURTLE_M = 0.02
"""Heights of water and turtle above the floor, so that one hides the other [m]."""


class TurtleDisplay:
    """Shows the last `turtlesim/msg/Pose`, and the water that all turtles share."""

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self, topic: str = "") -> None:
        # The same name has the same look each time; turtlesim itself chooses by chance.
        self._kind = sum(topic.encode("utf-8", "replace")) % len(LOOKS)
        self._pictures: tuple[Picture, Picture] | None = None
        self._shapes: list[Placed] = []

    def take(self, message: Any, stamp_ns: int) -> None:  # noqa: ARG002  # the pose has no header
        """Take a pose.

        Raises:
            DisplayError: a number is not finite.
        """
        self._shapes = []
        x, y, theta = float(message.x), float(message.y), float(message.theta)
        if not all(map(math.isfinite, (x, y, theta))):
            raise DisplayError("a number of its pose is not finite")
        water, turtle = self._made_pictures()
        # A picture begins at its corner, and the pose is that of the turtle's middle.
        pose = Transform.from_rpy(0.0, 0.0, theta, (x, y, TURTLE_M))
        half = turtle.size[0] / 2.0
        corner = pose.apply((-half, -half, 0.0))
        self._shapes = [
            Placed(water, WORLD_FRAME, position=(0.0, 0.0, WATER_M)),
            Placed(turtle, WORLD_FRAME, position=corner, rotation_xyzw=pose.rotation_xyzw),
        ]

    def _made_pictures(self) -> tuple[Picture, Picture]:
        """Return the water and the turtle, made once: the page keeps pictures that stay the same."""
        if self._pictures is None:
            water = np.full((1, 1, 3), DEFAULT_BACKGROUND, np.uint8)
            turtle = np.asarray(sprite(self._kind, 0.0, TURTLE_PX))
            size_m = len(turtle) / TURTLE_PX
            self._pictures = (
                Picture(water, (WORLD_SIZE_M, WORLD_SIZE_M)),
                Picture(turtle, (size_m, size_m)),
            )
        return self._pictures

    def clear(self) -> None:
        """Forget the pose."""
        self._shapes = []

    def shapes(self, now_ns: int) -> list[Placed]:  # noqa: ARG002  # they stay until the next message
        """Return water and turtle."""
        return self._shapes
