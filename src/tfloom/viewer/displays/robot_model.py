"""Robots, as their URDF describes what is seen of each link."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.visuals import BallForm, BoxForm, CylinderForm, Visual, read_visuals
from tfloom.viewer.mesh_files import read_model
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.shapes import Ball, Box, Cylinder, DisplayError, Placed, Shape

__all__ = ["RobotDisplay"]

MAX_VISUALS = 2000
"""Number of shapes of a robot that are drawn."""


class RobotDisplay:
    """Shows the robot of the last `std_msgs/msg/String` with a URDF. Each link is where its frame is."""

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self) -> None:
        self._text = ""
        self._shapes: list[Placed] = []

    def take(self, message: Any, stamp_ns: int) -> None:  # a description holds at all times
        """Take a description. What can be read of its meshes is shown, even where others can't.

        Raises:
            DisplayError: it is not a URDF, or one of its meshes can't be read.
        """
        if message.data == self._text:
            return
        self._text, self._shapes = message.data, []
        try:
            visuals = read_visuals(message.data)
        except UrdfError as error:
            raise DisplayError(f"it is not a URDF: {error}") from None
        faults = []
        for visual in visuals[:MAX_VISUALS]:
            try:
                self._shapes.extend(_placed(visual))
            except Exception as error:  # of one form: the others are shown
                faults.append(fault_text(error))
        if faults:
            raise DisplayError(faults[0] if len(faults) == 1 else f"{faults[0]} (and {len(faults) - 1} more)")

    def clear(self) -> None:
        """Forget the robot."""
        self._text, self._shapes = "", []

    def shapes(self, now_ns: int) -> list[Placed]:  # a description holds at all times
        """Return the shapes of the links."""
        return self._shapes


def _placed(visual: Visual) -> Iterator[Placed]:
    origin = visual.origin
    yield Placed(
        _shape(visual),
        visual.link,
        position=(origin.translation[0], origin.translation[1], origin.translation[2]),
        rotation_xyzw=origin.rotation_xyzw,
    )


def _shape(visual: Visual) -> Shape:
    form, (color, opacity) = visual.form, (visual.color, visual.opacity)
    if isinstance(form, BoxForm):
        return Box(form.size, color, opacity)
    if isinstance(form, CylinderForm):
        return Cylinder(form.radius, form.length, color, opacity)
    if isinstance(form, BallForm):
        return Ball((form.radius, form.radius, form.radius), color, opacity)
    return read_model(form.uri, form.scale, color if visual.has_color else None)
