"""Who drags which marker, and what the server of the markers is told of it."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.geometry_msgs.msg import Point, Pose, Quaternion
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerFeedback
from tfloom.tf2.transform import Transform

if TYPE_CHECKING:
    from tfloom.viewer.displays.interactive_markers import KnownMarker
    from tfloom.viewer.interactive.gizmos import Event, Key

__all__ = ["Dragging", "Outbox"]

KEEP_ALIVE_S = 0.25
"""Period at which a marker that is held still is said to be held [s]; its server gives it to others after a second."""

MAX_WAITING = 200
"""Number of messages that wait to be published."""

Feedback = InteractiveMarkerFeedback


@dataclass
class _Drag:
    """A marker that a page holds."""

    key: Key
    client: int
    control: str
    gizmo: Transform
    """The pose of the gizmo at the start."""
    marker: Transform
    """… and of the marker, in the fixed frame."""
    said_s: float
    """When its server was told of it last, on the monotonic clock [s]."""
    is_of_shape: bool
    """Whether the page holds a shape of the control, not the gizmo."""
    is_moved: bool = False
    """Whether there is a pose that its server was not told."""


class Dragging:
    """The drags of one namespace of markers. One thread may use it.

    A marker is dragged by one page at a time, the first one. Its drag ends when the page lets it go or is gone; its
    server hears of each end.

    Args:
        name: The start of the name under which a page is known to the server.
        publish: Publishes feedback.
        is_holding: Returns whether a scene of viser's number is there, and its page was heard of lately.
    """

    def __init__(
        self, name: str, publish: Callable[[Feedback], None], is_holding: Callable[[int], bool]
    ) -> None:
        self._name = name
        self._publish = publish
        self._is_holding = is_holding
        self._drags: dict[str, _Drag] = {}

    @property
    def held_gizmos(self) -> set[Key]:
        """The controls whose gizmos are dragged."""
        return {drag.key for drag in self._drags.values() if not drag.is_of_shape}

    def holds(self, client: int, key: Key) -> bool:
        """Return whether the page of a scene drags a control."""
        drag = self._drags.get(key[0])
        return drag is not None and (drag.client, drag.key) == (client, key)

    def take(self, event: Event, known: KnownMarker | None, fixed_from_frame: Transform | None) -> None:
        """Take what a page has done with a gizmo, or with a shape in its place.

        Args:
            event: What it has done.
            known: The marker; None: there is none of this name any more.
            fixed_from_frame: The pose of its frame in the fixed one; None: it is not known.
        """
        name, number = event.key
        if known is None or fixed_from_frame is None or number >= len(known.message.controls):
            return
        drag = self._drags.get(name)
        if event.phase == "start":
            if drag is None and self._is_holding(event.client):
                self._start(event, known, fixed_from_frame)
            return
        held = (event.key, event.client, event.is_of_shape)
        if drag is None or (drag.key, drag.client, drag.is_of_shape) != held:
            return  # of one who was second, or whose drag was ended
        _move(drag, event.place, known, fixed_from_frame)
        if event.phase == "end":
            self.end(name, known)

    def _start(self, event: Event, known: KnownMarker, fixed_from_frame: Transform) -> None:
        name, number = event.key
        place = fixed_from_frame @ known.frame_from_marker
        control = known.message.controls[number].name
        drag = self._drags[name] = _Drag(
            event.key, event.client, control, event.place, place, time.monotonic(), event.is_of_shape
        )
        known.is_dragged = True
        self._say(drag, known, Feedback.MOUSE_DOWN)

    def look(self, markers: dict[str, KnownMarker]) -> None:
        """Tell the server what has moved or is held, and end the drags of pages and markers that are gone."""
        now_s = time.monotonic()
        for name, drag in list(self._drags.items()):
            known = markers.get(name)
            if known is None or not self._is_holding(drag.client):
                self.end(name, known)
            elif drag.is_moved:
                self._say(drag, known, Feedback.POSE_UPDATE)
            elif now_s - drag.said_s >= KEEP_ALIVE_S:
                self._say(drag, known, Feedback.KEEP_ALIVE)

    def end(self, name: str, known: KnownMarker | None) -> None:
        """End the drag of a marker, of which there may be none: with its last pose, and the button up."""
        if (drag := self._drags.pop(name, None)) is None:
            return
        if known is None:  # its server has erased it, and knows nothing of it any more
            return
        try:
            if drag.is_moved:
                self._say(drag, known, Feedback.POSE_UPDATE)
            self._say(drag, known, Feedback.MOUSE_UP)
        finally:
            known.release()

    def end_all(self, markers: dict[str, KnownMarker]) -> None:
        """End all drags."""
        for name in list(self._drags):
            self.end(name, markers.get(name))

    def _say(self, drag: _Drag, known: KnownMarker, event_type: int) -> None:
        drag.said_s, drag.is_moved = time.monotonic(), False
        self.say(drag.client, known, drag.control, event_type)

    def say(
        self, client: int, known: KnownMarker, control: str, event_type: int, menu_entry: int = 0
    ) -> None:
        """Tell the server of the markers what a page has done.

        Args:
            client: Viser's number of the page's scene.
            known: The marker.
            control: The name of the control.
            event_type: As `InteractiveMarkerFeedback.BUTTON_CLICK`.
            menu_entry: The number of a menu's entry that was chosen.
        """
        marker = known.message
        self._publish(
            Feedback(
                header=Header(frame_id=marker.header.frame_id, stamp=marker.header.stamp),
                client_id=f"{self._name}/{client}",
                marker_name=marker.name,
                control_name=control,
                event_type=event_type,
                pose=marker.pose,
                menu_entry_id=menu_entry,
            )
        )


class Outbox:
    """Feedback on its way to a server of markers, one message at a time. One thread may use it.

    A server in Python keeps one message until it has time for it: of several at once it would have the last one, and a
    marker would not stand where it was let go.

    Args:
        write: Publishes feedback.
    """

    def __init__(self, write: Callable[[Feedback], None]) -> None:
        self._write = write
        self._waiting: list[Feedback] = []

    def put(self, feedback: Feedback) -> None:
        """Add feedback; a pose takes the place of one of its marker that still waits."""
        mine = [one for one in self._waiting if one.marker_name == feedback.marker_name]
        held = {Feedback.POSE_UPDATE, Feedback.KEEP_ALIVE}
        if mine and feedback.event_type in held and mine[-1].event_type == feedback.event_type:
            self._waiting = [feedback if one is mine[-1] else one for one in self._waiting]
        elif len(self._waiting) < MAX_WAITING:
            self._waiting.append(feedback)
        else:
            self.flush()
            self._write(feedback)

    def send_one(self) -> None:
        """Publish what has waited for longest, if there is something."""
        if self._waiting:
            self._write(self._waiting.pop(0))

    def flush(self) -> None:
        """Publish all that waits."""
        while self._waiting:
            self.send_one()


def _move(drag: _Drag, gizmo: Transform, known: KnownMarker, fixed_from_frame: Transform) -> None:
    """Move a marker with its gizmo, which may be turned against it."""
    turn = (
        Transform(rotation_xyzw=gizmo.rotation_xyzw)
        @ Transform(rotation_xyzw=drag.gizmo.rotation_xyzw).inverse()
    )
    turned = turn @ Transform(rotation_xyzw=drag.marker.rotation_xyzw)
    place = fixed_from_frame.inverse() @ Transform(gizmo.translation, turned.rotation_xyzw)
    pose = message_of(place)
    if pose != known.message.pose:
        known.message.pose = pose
        drag.is_moved = True


def message_of(place: Transform) -> Any:
    """Return a pose as a message."""
    x, y, z = place.translation
    qx, qy, qz, qw = place.rotation_xyzw
    return Pose(position=Point(x=x, y=y, z=z), orientation=Quaternion(x=qx, y=qy, z=qz, w=qw))
