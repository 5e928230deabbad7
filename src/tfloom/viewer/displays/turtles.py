"""turtlesim's world: a floor, and a turtle on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.turtlesim.art import LOOKS, turtle_shapes
from tfloom.turtlesim.world import WORLD_SIZE_M
from tfloom.viewer.shapes import Box, DisplayError, Mesh, Placed

__all__ = ["WORLD_FRAME", "TurtleDisplay"]

WORLD_FRAME = "world"
"""The frame in which turtles are, as the broadcasters of the tutorials name it."""
WATER = (69, 86, 255)
LAYER_M = 0.004
"""Distance between the layers of a turtle's picture [m]."""


class TurtleDisplay:
    """Shows the last `turtlesim/msg/Pose`, and the water that all turtles share."""

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self, topic: str = "") -> None:
        # The same name has the same look each time; turtlesim itself chooses by chance.
        self._look = LOOKS[sum(topic.encode("utf-8", "replace")) % len(LOOKS)]
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
        middle = WORLD_SIZE_M / 2.0
        water = Box((WORLD_SIZE_M, WORLD_SIZE_M, 0.02), WATER)
        rotation = Transform.from_rpy(0.0, 0.0, theta).rotation_xyzw
        self._shapes = [
            Placed(water, WORLD_FRAME, position=(middle, middle, -0.015)),
            *(
                Placed(mesh, WORLD_FRAME, position=(x, y, (layer + 1) * LAYER_M), rotation_xyzw=rotation)
                for layer, mesh in enumerate(self._meshes())
            ),
        ]

    def _meshes(self) -> list[Mesh]:
        """Return the turtle's polygons by colour, the lower ones first, each as a fan around its middle."""
        layers: list[tuple[tuple[int, int, int], list[Any], list[Any]]] = []
        for shape in turtle_shapes(self._look):
            if not layers or layers[-1][0] != shape.fill:
                layers.append((shape.fill, [], []))
            _, vertices, faces = layers[-1]
            points = np.array(shape.points)
            first = sum(map(len, vertices))
            rim = np.arange(len(points))
            vertices.append(np.vstack([points.mean(axis=0), points]))
            faces.append(
                np.stack([np.zeros(len(points)), rim + 1, (rim + 1) % len(points) + 1], axis=1) + first
            )
        return [
            Mesh(
                np.pad(np.vstack(vertices), ((0, 0), (0, 1))).astype(np.float32),
                np.vstack(faces).astype(np.uint32),
                fill,
            )
            for fill, vertices, faces in layers
        ]

    def clear(self) -> None:
        """Forget the pose."""
        self._shapes = []

    def shapes(self, now_ns: int) -> list[Placed]:  # noqa: ARG002  # they stay until the next message
        """Return water and turtle."""
        return self._shapes
