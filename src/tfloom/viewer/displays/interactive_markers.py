"""Interactive markers: what a server has told of them, by the numbers of its updates; their shapes and controls."""

from __future__ import annotations

import copy
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerControl, InteractiveMarkerUpdate
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import pose_of, shown_text, stamp_of
from tfloom.viewer.displays.markers import shapes_of_marker
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.shapes import Axes, DisplayError, Placed, Text

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Values

__all__ = ["Handle", "InteractiveMarkersDisplay", "KnownMarker", "Part", "handle_of", "rotation_of"]

MAX_MARKERS = 500
"""Number of interactive markers that are kept."""
MAX_PARTS = 4000
"""Number of shapes of all of them."""
MAX_PENDING = 1000
"""How many updates wait for the response of the server; of more, the oldest are missing, and it is asked again."""
GIZMO_M = 0.7
"""Length of a gizmo of a marker whose scale is 1 [m]."""

_Control = InteractiveMarkerControl
_ONE, _TWO, _ALL = (True, False, False), (False, True, True), (True, True, True)


class Handle(NamedTuple):
    """What of a gizmo can be dragged, as viser has it; the axis of a control is its x axis."""

    axes: tuple[bool, bool, bool] = _ALL
    """A plane or a rotation is there where the two axes in it are."""
    moves_on_axes: bool = False
    moves_in_planes: bool = False
    rotates: bool = False


_HANDLES = {
    _Control.MOVE_AXIS: Handle(_ONE, moves_on_axes=True),
    _Control.MOVE_PLANE: Handle(_TWO, moves_in_planes=True),
    _Control.ROTATE_AXIS: Handle(_TWO, rotates=True),
    _Control.MOVE_ROTATE: Handle(_TWO, moves_in_planes=True, rotates=True),
    _Control.MOVE_3D: Handle(moves_on_axes=True, moves_in_planes=True),
    _Control.ROTATE_3D: Handle(rotates=True),
    _Control.MOVE_ROTATE_3D: Handle(moves_on_axes=True, moves_in_planes=True, rotates=True),
}


def handle_of(control: Any) -> Handle | None:
    """Return what can be dragged of a control; None for one that is only clicked."""
    return _HANDLES.get(control.interaction_mode)


class Part(NamedTuple):
    """A shape of an interactive marker."""

    placed: Placed
    """In the marker's own frame, or in the frame that it names."""
    control: int
    """The number of its control; -1 of what belongs to none."""


@dataclass
class KnownMarker:
    """An interactive marker."""

    message: Any
    """As its server has it, but for the pose, which is the user's while it is dragged."""
    parts: list[Part]
    fault: str = ""
    """Why a shape of it can't be drawn."""
    later: Any = None
    """The pose and the header that its server has set while it is dragged; None: none."""
    is_dragged: bool = False
    added: tuple[tuple[bool, bool], list[Part]] | None = None
    """The shapes that settings add, with these settings."""
    size_m: float = field(init=False)
    """Length of its gizmos [m]."""

    def __post_init__(self) -> None:
        scale = float(self.message.scale)
        self.size_m = GIZMO_M * (scale if 0.0 < scale < 1e6 else 1.0)

    @property
    def frame_from_marker(self) -> Transform:
        """Its pose in its frame.

        Raises:
            DisplayError: a number of it is not finite.
        """
        return Transform(*pose_of(self.message.pose))

    @property
    def base(self) -> Placed:
        """Its place, without a shape of its own.

        Raises:
            DisplayError: a number of its pose is not finite.
        """
        position, rotation = pose_of(self.message.pose)
        header = self.message.header
        return Placed(Text("", 0.1), header.frame_id, stamp_of(header), position, rotation)

    def release(self) -> None:
        """Take the pose that the server has set while it was dragged."""
        self.is_dragged = False
        if self.later is not None:
            self.message.pose, self.message.header = self.later
            self.later = None


class InteractiveMarkersDisplay:
    """Shows `visualization_msgs/msg/InteractiveMarkerUpdate`, from the server's response to a request on.

    An update counts the one before by one. Where one is missing, or comes twice with another content, as of a server
    that was started again, `needs_all` is set until the server has told all of its markers.

    Args:
        settings: A value for each setting; it may change.
    """

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self, settings: Values) -> None:
        self.settings = settings
        self.markers: dict[str, KnownMarker] = {}
        self.needs_all = True
        """Whether the server has to be asked for all of its markers."""
        self.fault = ""
        """What of the last messages can't be shown."""
        self._number = 0
        """The number of the last update that is in `markers`."""
        self._last: Any = None
        self._pending: list[Any] = []
        """Updates that have come while all markers are asked for."""

    def clear(self) -> None:
        """Forget all markers."""
        self.markers.clear()
        self._pending.clear()
        self.needs_all, self.fault, self._last = True, "", None

    def initialize(self, number: int, markers: Iterable[Any]) -> None:
        """Take all markers of the server, and then the updates since.

        Args:
            number: The number of the last update that is in them.
            markers: The markers.
        """
        told = {marker.name: marker for marker in markers}
        for name in self.markers.keys() - told.keys():
            del self.markers[name]
        self.needs_all, self.fault = False, ""
        self._number, self._last = number, None
        for marker in told.values():
            self._set_marker(marker)
        pending, self._pending = self._pending, []
        for update in pending:
            if update.seq_num > number:
                self.take(update, 0)

    def take(self, message: Any, stamp_ns: int) -> None:
        """Take the next update."""
        if self.needs_all:
            self._pending = [*self._pending[1 - MAX_PENDING :], message]
            return
        is_update = message.type == InteractiveMarkerUpdate.UPDATE
        if message.seq_num == self._number and (not is_update or message == self._last):
            return
        if not is_update or message.seq_num != self._number + 1:
            self.needs_all = True
            self._pending = [message] if is_update else []
            return
        self._number, self._last = message.seq_num, message
        for marker in message.markers:
            self._set_marker(marker)
        for moved in message.poses:
            if (known := self.markers.get(moved.name)) is not None:
                known.later = moved.pose, moved.header
                if not known.is_dragged:
                    known.release()
        for name in message.erases:
            self.markers.pop(name, None)

    def _set_marker(self, message: Any) -> None:
        before = self.markers.get(message.name)
        if before is None and len(self.markers) >= MAX_MARKERS:
            self.fault = f"there are more than {MAX_MARKERS} interactive markers"
            return
        message = copy.copy(message)  # its pose is changed here, that of the log isn't
        parts, fault = self._parts_of(message)
        known = KnownMarker(message, parts, fault)
        if before is not None and before.is_dragged:
            # Its user has it: what its server says counts when it is let go.
            known.is_dragged, known.later = True, (message.pose, message.header)
            message.pose, message.header = before.message.pose, before.message.header
        self.markers[message.name] = known

    def _parts_of(self, message: Any) -> tuple[list[Part], str]:
        parts: list[Part] = []
        fault = ""
        for number, control in enumerate(message.controls):
            for marker in control.markers:
                try:
                    parts += [Part(placed, number) for placed in shapes_of_marker(marker)]
                except Exception as error:  # of one shape: the others are shown
                    reason = fault_text(error)
                    fault = fault or f"a shape of {shown_text(message.name, 40)!r} can't be drawn: {reason}"
        if len(parts) > MAX_PARTS:
            fault = fault or f"{len(parts)} shapes of one marker, of which {MAX_PARTS} are shown"
        return parts[:MAX_PARTS], fault

    def parts_of(self, known: KnownMarker) -> list[Part]:
        """Return the shapes of a marker, with what the settings add."""
        wanted = self.settings["descriptions"], self.settings["axes"]
        # The same shapes as long as nothing changes: the page has them already.
        if known.added is None or known.added[0] != wanted:
            known.added = wanted, self._added_to(known)
        return [*known.parts, *known.added[1]]

    def _added_to(self, known: KnownMarker) -> list[Part]:
        scale = known.size_m / GIZMO_M
        added: list[Part] = []
        description = known.message.description
        if self.settings["descriptions"] and description:
            text = Text(shown_text(description, 100), 0.12 * scale)
            added.append(Part(Placed(text, "", position=(0.0, 0.0, 0.9 * scale)), -1))
        if self.settings["axes"]:
            one = np.array([[0.0, 0.0, 0.0]], np.float32), np.array([[0.0, 0.0, 0.0, 1.0]], np.float32)
            added.append(Part(Placed(Axes(*one, 0.4 * scale, 0.02 * scale), ""), -1))
        return added

    def shapes(self, now_ns: int) -> list[Placed]:
        """Return nothing: where shapes are depends on the pose of their marker, which `parts_of` leaves out."""
        return []

    @property
    def status(self) -> str:
        """What can't be shown; empty if all is."""
        return self.fault or next((known.fault for known in self.markers.values() if known.fault), "")


def rotation_of(control: Any) -> Transform:
    """Return the rotation of a control against its marker, or against the marker's frame.

    Raises:
        DisplayError: a number of it is not finite.
    """
    turn = control.orientation
    x, y, z, w = (float(part) for part in (turn.x, turn.y, turn.z, turn.w))
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if not math.isfinite(length):
        raise DisplayError("the orientation of a control is not finite")
    if length < 1e-9:
        return Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    return Transform((0.0, 0.0, 0.0), (x / length, y / length, z / length, w / length))
