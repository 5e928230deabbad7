"""Robots, as their URDF describes what is seen of each link."""

from __future__ import annotations

import itertools
import time
from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.visuals import BallForm, BoxForm, CylinderForm, Visual, read_collisions, read_visuals
from tfloom.viewer.mesh_files import read_model, translucent
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.shapes import Ball, Box, Cylinder, DisplayError, Model, Placed, Shape
from tfloom.viewer.textures import read_texture

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values
    from tfloom.viewer.textures import Texture

__all__ = ["RobotDisplay"]

MAX_VISUALS = 2000
"""Number of shapes of a robot that are drawn."""
LOAD_S = 0.1
"""How long files of meshes are read for one picture [s]; one file is in any case."""
MAX_MESH_BYTES = 512 * 1024 * 1024
"""Size of all meshes of a robot, as pages get them."""
STAND_IN_OPACITY = 0.6
"""Of a form that stands in for what can't be seen."""


class RobotDisplay:
    """Shows the robot of the last `std_msgs/msg/String` with a URDF. Each link is where its frame is.

    Files of meshes are read a few at a time, as `shapes` is called. A link of which one can't be read has the forms
    with which it collides. A form of which the texture can't be read has its colour.

    Attributes:
        near: The folder of the description, if that is a file's: meshes are looked for around it, too.
        status: What is not shown, and why; empty if all is.
    """

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""
    near: Path | None = None

    def __init__(self, settings: Values) -> None:
        self.settings = settings
        self.clear()

    def clear(self) -> None:
        """Forget the robot."""
        self._text = ""
        self._shapes: list[Placed] = []
        self._waiting: deque[Visual] = deque()
        """The forms of which there are no shapes yet."""
        self._count = 0
        self._stand_ins: dict[str, list[Visual]] = {}
        """The forms of collisions that were not asked for yet, by link."""
        self._links: list[str] = []
        self._faults: list[str] = []
        self._mesh_bytes = 0
        self._has_stand_in = False
        self.status = ""

    @property
    def is_whole(self) -> bool:
        """Whether each file was read, or can't be."""
        return not self._waiting

    def take(self, message: Any, stamp_ns: int) -> None:  # a description holds at all times
        """Take a description; one that is shown whole changes nothing when it comes again.

        Raises:
            DisplayError: it is not a URDF.
        """
        if message.data == self._text and not self._faults:
            return
        self.clear()
        try:
            visuals, collisions = read_visuals(message.data), read_collisions(message.data)
        except UrdfError as error:
            raise DisplayError(f"it is not a URDF: {error}") from None
        self._text = message.data
        self._links = list(dict.fromkeys(form.link for form in (*visuals, *collisions)))
        if self.settings["collision"]:
            self._wait_for(map(_as_stand_in, self._not_hidden(collisions)))
        if not self.settings["visual"]:
            return
        for form in self._not_hidden(collisions):
            self._stand_ins.setdefault(form.link, []).append(_as_stand_in(form))
        self._wait_for(self._not_hidden(visuals))
        if not visuals and not self.settings["collision"]:
            self._faults.append("nothing of it is visual")
            self._wait_for(itertools.chain.from_iterable(self._stand_ins.values()))
            self._stand_ins.clear()

    def _not_hidden(self, forms: Iterable[Visual]) -> list[Visual]:
        return [form for form in forms if form.link not in self.settings["hidden_links"]]

    def parts(self) -> list[str]:
        """Return the links that have a form."""
        return self._links

    def _wait_for(self, forms: Iterable[Visual]) -> None:
        added = list(itertools.islice(forms, MAX_VISUALS - self._count))
        self._count += len(added)
        self._waiting.extend(added)

    def shapes(self, now_ns: int) -> list[Placed]:  # a description holds at all times
        """Return the shapes of the links that are there so far; new ones are behind the others."""
        end_s = time.monotonic() + LOAD_S
        while self._waiting:
            self._make(self._waiting.popleft())
            if time.monotonic() > end_s:
                break
        self.status = self._said()
        return self._shapes

    def _make(self, form: Visual) -> None:
        """Make the shape of a form, or note why that can't be done, and let its link have its stand-ins."""
        try:
            texture = self._texture_of(form)
            placed = _placed(form, texture, self.near, self.settings["opacity"])
            self._count_bytes(placed.shape)
        except Exception as error:  # of one form: the others are shown
            self._faults.append(fault_text(error))
            self._wait_for(self._stand_ins.pop(form.link, ()))
        else:
            self._shapes.append(placed)
            self._has_stand_in |= form.opacity == STAND_IN_OPACITY and not form.has_color
            if texture is not None and not texture.is_plain and not _has_texture(placed.shape):
                self._note(f"a form without texture coordinates has the mean colour of {form.texture}")
        if not self._waiting and not self._shapes:  # then another link may have what is to be seen
            self._wait_for(itertools.chain.from_iterable(self._stand_ins.values()))
            self._stand_ins.clear()

    def _texture_of(self, form: Visual) -> Texture | None:
        if not form.texture:
            return None
        try:
            return read_texture(form.texture, self.near)
        except DisplayError as error:
            self._note(f"shown without a texture: {error}")
            return None

    def _note(self, fault: str) -> None:
        """Note a fault, once for all the forms that have it."""
        if fault not in self._faults:
            self._faults.append(fault)

    def _count_bytes(self, shape: Shape) -> None:
        if isinstance(shape, Model):
            self._mesh_bytes += len(shape.glb)
            if self._mesh_bytes > MAX_MESH_BYTES:
                self._mesh_bytes -= len(shape.glb)
                raise DisplayError(f"the meshes of the robot have more than {MAX_MESH_BYTES} bytes")

    def _said(self) -> str:
        if self._waiting:
            return f"{self._count - len(self._waiting)} of {self._count} forms are read"
        if not self._faults:
            return ""
        more = f" (and {len(self._faults) - 1} more)" if len(self._faults) > 1 else ""
        stand_in = "forms of collisions stand in: " if self._has_stand_in else ""
        return f"{stand_in}{self._faults[0]}{more}"


def _as_stand_in(form: Visual) -> Visual:
    return Visual(form.link, form.origin, form.form, opacity=STAND_IN_OPACITY)


def _placed(visual: Visual, texture: Texture | None, near: Path | None, opacity: float) -> Placed:
    origin = visual.origin
    return Placed(
        _shape(visual, texture, near, opacity),
        visual.link,
        position=(origin.translation[0], origin.translation[1], origin.translation[2]),
        rotation_xyzw=origin.rotation_xyzw,
    )


def _shape(visual: Visual, texture: Texture | None, near: Path | None, share: float) -> Shape:
    form, (color, opacity) = visual.form, (visual.color, visual.opacity * share)
    if texture is not None:  # in place of the colour, of which the opacity is a part
        color, opacity = texture.mean, share
    if isinstance(form, BoxForm):
        return Box(form.size, color, opacity)
    if isinstance(form, CylinderForm):
        return Cylinder(form.radius, form.length, color, opacity)
    if isinstance(form, BallForm):
        return Ball((form.radius, form.radius, form.radius), color, opacity)
    is_colored = visual.has_color and texture is None
    model = read_model(form.uri, form.scale, color if is_colored else None, near, texture)
    return model if opacity >= 1.0 else replace(model, glb=translucent(model.glb, opacity))


def _has_texture(shape: Shape) -> bool:
    return isinstance(shape, Model) and shape.has_texture
