"""The display of a namespace of interactive markers, with its ends on the graph."""

from __future__ import annotations

import queue
import time
from collections.abc import Callable, Coroutine, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom._native import ReadyQueue
from tfloom.interfaces.visualization_msgs.msg import (
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    MenuEntry,
)
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.tf2.errors import TransformException
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import MAX_COORDINATE_M, shown_text
from tfloom.viewer.displays.interactive_markers import (
    InteractiveMarkersDisplay,
    KnownMarker,
    handle_of,
    rotation_of,
)
from tfloom.viewer.displays.kinds import UPDATE_SUFFIX
from tfloom.viewer.feed import Feed, pose_in
from tfloom.viewer.interactive.dragging import Dragging, Outbox
from tfloom.viewer.interactive.gizmos import Event, Gizmo, Gizmos, Key
from tfloom.viewer.interactive.grabs import MODES, Grab, Sight, sight_of
from tfloom.viewer.obstacles import MAX_STATUS, transform_text
from tfloom.viewer.page_command import PageError, fault_text, text, whole
from tfloom.viewer.shapes import DisplayError, Placed, Shape
from tfloom.viewer.topic_log import START, Cursor

if TYPE_CHECKING:
    from viser import SceneApi

    from tfloom.rmw.base import NodeName, Participant, Writer
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.displays.kinds import Kind
    from tfloom.viewer.drawing import Pose

__all__ = ["MarkersFeed", "Station"]

AGAIN_S = 1.0
"""How long after a request without a response the next one is sent [s]."""
RESPONSE_S = 5.0
"""The longest wait for the server, and again for its response [s]."""
LOOK_S = 0.5
"""Period at which is looked whether it is still the same server [s]."""
MAX_EVENTS = 1000
"""Number of events of pages that wait; further ones are dropped."""
MAX_ENDS = 1000
"""How many ends of drags may wait beyond these: without its end a marker would be held as long as its page is there."""
MAX_ENTRIES = 500
"""Number of a menu's entries that a page gets."""


class Station(NamedTuple):
    """What displays of interactive markers have of the graph, the scene and its pages."""

    participant: Participant
    node: NodeName
    scene: SceneApi
    is_holding: Callable[[int], bool]
    """Returns whether a scene of viser's number is there, and its page was heard of lately."""
    answer: Callable[[int, dict[str, Any]], None]
    """Gives the page of a scene an answer."""


class _Click(NamedTuple):
    """A click on a shape."""

    client: int
    part: int
    """The number of the shape among those that were drawn."""
    is_for_menu: bool
    at: tuple[float, float]
    """The place in the scene, from 0 to 1."""


class _Hold(NamedTuple):
    """A drag of a shape."""

    client: int
    part: int
    """The number of the shape among those that were drawn."""
    phase: str
    """`start`, `update` or `end`."""
    sight: Sight | None
    """None: what the page says of its pointer is of no use."""
    point: tuple[float, float, float]
    """The point of the shape that was grabbed, in the fixed frame [m]."""


class MarkersFeed(Feed):
    """What a display of interactive markers shows, and what it tells their server.

    Args:
        topic: The topic of the server's updates.
        kind: The kind of the display.
        cursor: A reader of the topic.
        station: The graph, the scene and its pages.
    """

    def __init__(self, topic: str, kind: Kind, cursor: Cursor, station: Station) -> None:
        self._station = station
        self._namespace = topic.removesuffix(UPDATE_SUFFIX)
        self._events: queue.SimpleQueue[Event | _Click | _Hold] = queue.SimpleQueue()
        self._gizmos = Gizmos(station.scene, self._put)
        name = f"{station.node.full}{topic}"
        self._outbox = Outbox(self._publish)
        self._dragging = Dragging(name, self._outbox.put, station.is_holding)
        self._writer: Writer | None = None
        self._request: ServiceRequest | None = None
        self._is_asked = False
        self._next_ask_s = self._next_look_s = 0.0
        self._servers: frozenset[str] = frozenset()
        self._refusal = ""
        """Why the server's response can't be had."""
        self._drawn: list[tuple[str, int]] = []
        """The marker and the control of each shape that was drawn."""
        self._grabs: dict[int, Grab] = {}
        """The shapes that pages hold, by viser's numbers of their scenes."""
        self._frames: dict[str, Transform] = {}
        """The pose of each marker's frame in the fixed one, where it is known."""
        self._fixed_frame = ""
        super().__init__(topic, kind, cursor)

    @property
    def markers(self) -> dict[str, KnownMarker]:
        """The markers."""
        return self._shown.markers

    @property
    def _shown(self) -> InteractiveMarkersDisplay:
        display = self.display
        assert isinstance(display, InteractiveMarkersDisplay)  # noqa: S101  # for the type checker; its kind says so
        return display

    # Its ends on the graph.

    def read(self, cursor: Cursor) -> None:
        """Read from another reader of the topic, and ask the server for all of its markers."""
        super().read(cursor)
        cursor.number = START
        for _ in cursor.read():  # what has come before is in what the server tells
            pass
        self._close_ends()
        try:
            self._open_ends(self._station.participant, self._station.node)
        except BaseException:
            self._close_ends()
            raise

    def _open_ends(self, participant: Participant, node: NodeName) -> None:
        self._writer = participant.create_writer(
            node, topic_of(InteractiveMarkerFeedback, f"{self._namespace}/feedback"), QoS(depth=100)
        )
        self._request = ServiceRequest(
            participant,
            node,
            f"{self._namespace}/get_interactive_markers",
            GetInteractiveMarkers,
            ReadyQueue(),
        )

    def close(self) -> None:
        """End all drags, and leave the graph; the markers are asked for again by `read`."""
        try:
            self._dragging.end_all(self.markers)
            self._outbox.flush()
        finally:
            self._gizmos.clear()
            self._close_ends()
            self._shown.clear()
            super().close()

    def _close_ends(self) -> None:
        writer, request = self._writer, self._request
        self._writer = self._request = None
        self._is_asked, self._next_ask_s, self._servers = False, 0.0, frozenset()
        if request is not None:
            request.close()
        if writer is not None:
            writer.close()

    def _publish(self, feedback: InteractiveMarkerFeedback) -> None:
        if self._writer is not None:
            self._writer.write(cdr.encode(feedback))

    def _listen(self) -> None:
        """Take what the server has told."""
        display = self._shown
        for entry in self._cursor.read():
            try:
                display.take(entry.message(), entry.stamp_ns)
            except Exception as error:  # of one update, which is missing then
                display.needs_all = True
                self._refusal = f"an update can't be read: {fault_text(error)}"
        if not self.is_published:  # the server has ended, or erases no longer
            if self.markers or self._is_asked:
                self._dragging.end_all(self.markers)
                display.clear()
                self._is_asked = False
            return
        if self._request is None:
            return
        now_s = time.monotonic()
        if now_s >= self._next_look_s:
            self._next_look_s = now_s + LOOK_S
            servers = self._request.servers
            display.needs_all |= servers != self._servers
            self._servers = servers
        if display.needs_all:
            self._ask(self._request, now_s)

    def _ask(self, request: ServiceRequest, now_s: float) -> None:
        if not self._is_asked:
            if now_s < self._next_ask_s:
                return
            request.ask(
                cdr.encode(GetInteractiveMarkers.Request()), response_s=RESPONSE_S, server_s=RESPONSE_S
            )
            self._is_asked = True
        try:
            response = request.take()
        except ServiceRequestError as error:
            self._refusal = str(error)
            self._is_asked, self._next_ask_s = False, now_s + AGAIN_S
            return
        if response is not None:
            self._is_asked, self._refusal = False, ""
            self._shown.initialize(response.sequence_number, response.markers)

    # What pages do.

    def _put(self, event: Event | _Click | _Hold) -> None:
        """Note an event; on a thread of viser."""
        is_end = not isinstance(event, _Click) and event.phase == "end"
        if self._events.qsize() < MAX_EVENTS + MAX_ENDS * is_end:
            self._events.put(event)

    @property
    def on_click(self) -> Callable[[int, Any], None]:
        """What takes the number of a shape that is clicked and viser's event, on a thread of viser."""
        return self._note_click

    def _note_click(self, index: int, event: Any) -> None:
        across, down = event.screen_pos
        self._put(_Click(event.client_id, index, event.modifier is not None, (float(across), float(down))))

    def on_drag(self, index: int) -> Callable[[Any], Coroutine[Any, Any, None]] | None:
        """Return what takes viser's events of a drag of a shape that was drawn; None for one that isn't dragged."""
        name, number = self._drawn[index]
        known = self.markers.get(name)
        if known is None or number < 0 or known.message.controls[number].interaction_mode not in MODES:
            return None

        async def hear(event: Any) -> None:  # not on viser's pool of threads, where the order would be lost
            camera = event.client.camera
            sight = sight_of(camera.position, camera.wxyz, event.end_position)
            point = tuple(event.start_position)
            if not (np.abs(point) < MAX_COORDINATE_M).all():
                sight = None
            if sight is not None or event.phase == "end":
                self._put(_Hold(event.client_id, index, event.phase, sight, point))

        return hear

    def _take_events(self) -> None:
        while True:
            try:
                event = self._events.get_nowait()
            except queue.Empty:
                return
            if isinstance(event, _Click):
                self._take_click(event)
            elif isinstance(event, _Hold):
                self._take_hold(event)
            else:
                name, _ = event.key
                self._dragging.take(event, self.markers.get(name), self._frames.get(name))

    def _take_click(self, click: _Click) -> None:
        if click.part >= len(self._drawn):
            return
        name, number = self._drawn[click.part]
        if (known := self.markers.get(name)) is None or number >= len(known.message.controls):
            return
        control = known.message.controls[number] if number >= 0 else InteractiveMarkerControl()
        if control.interaction_mode == InteractiveMarkerControl.BUTTON and not click.is_for_menu:
            self._dragging.say(click.client, known, control.name, InteractiveMarkerFeedback.BUTTON_CLICK)
        elif known.message.menu_entries:
            self._station.answer(click.client, {"marker_menu": self._menu_of(known, control.name, click.at)})

    def _take_hold(self, hold: _Hold) -> None:
        """Move a marker by a shape of its own, as by its gizmo."""
        grab = self._grab_of(hold) if hold.phase == "start" else self._grabs.get(hold.client)
        if grab is None:
            return
        if hold.phase != "start" and hold.sight is not None:
            grab.move(hold.sight)
        known, frame = self.markers.get(grab.key[0]), self._frames.get(grab.key[0])
        event = Event(grab.key, hold.client, hold.phase, grab.place, is_of_shape=True)
        self._grabs[hold.client] = grab
        self._dragging.take(event, known, frame)

    def _grab_of(self, hold: _Hold) -> Grab | None:
        """Return what a page has grabbed; None if it isn't there any more, or nothing that is dragged."""
        if hold.sight is None or hold.part >= len(self._drawn):
            return None
        name, number = self._drawn[hold.part]
        known, frame = self.markers.get(name), self._frames.get(name)
        if known is None or frame is None or not 0 <= number < len(known.message.controls):
            return None
        control = known.message.controls[number]
        if control.interaction_mode not in MODES:
            return None
        try:
            place = frame @ known.frame_from_marker
            turn = _turn_of(control, frame, place)
        except DisplayError:  # the status has it
            return None
        return Grab(
            (name, number),
            control.interaction_mode,
            place,
            turn,
            hold.sight,
            np.array(hold.point),
            faces_view=control.orientation_mode == InteractiveMarkerControl.VIEW_FACING,
        )

    def _menu_of(self, known: KnownMarker, control: str, at: tuple[float, float]) -> dict[str, Any]:
        entries = known.message.menu_entries
        return {
            "topic": self.topic,
            "marker": known.message.name,
            "control": control,
            "title": shown_text(known.message.description or known.message.name),
            "at": at,
            "entries": [
                {"id": entry.id, "parent": entry.parent_id, "title": shown_text(entry.title)}
                for entry in entries[:MAX_ENTRIES]
            ],
        }

    def choose_entry(self, client: int, command: Mapping[str, Any]) -> None:
        """Tell the server that an entry of a menu was chosen.

        Args:
            client: Viser's number of the page's scene.
            command: What the page asks for: `marker`, `control` and `entry`.

        Raises:
            PageError: there is no such entry, or it is a command, which is not run.
        """
        name, control, number = text(command, "marker"), text(command, "control"), whole(command, "entry")
        if (known := self.markers.get(name)) is None:
            raise PageError(f"there is no marker {shown_text(name)!r} any more")
        entries = known.message.menu_entries
        entry = next((entry for entry in entries if entry.id == number), None)
        if entry is None or any(other.parent_id == number for other in entries if other.id != number):
            raise PageError(f"the menu of {shown_text(name)!r} has no entry {number} that can be chosen")
        if entry.command_type != MenuEntry.FEEDBACK:
            kind = "rosrun" if entry.command_type == MenuEntry.ROSRUN else "roslaunch"
            raise PageError(
                f"{shown_text(entry.title)!r} would start a program by {kind}, which a page doesn't do"
            )
        self._dragging.say(client, known, control, InteractiveMarkerFeedback.MENU_SELECT, number)

    # What is shown.

    @property
    def frame_id(self) -> str:
        """The frame of the first marker; empty where there is none."""
        frames = [known.message.header.frame_id.removeprefix("/") for known in self.markers.values()]
        return next(iter(frames), "")

    def draw(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, now_ns: int
    ) -> list[tuple[Shape, Pose | None]]:
        """Return the shapes to draw, each with its pose in the fixed frame; and have the gizmos there.

        Args:
            buffer: The transforms.
            fixed_frame: The fixed frame.
            held_ns: The time that the page shows [ns since epoch]; None: the newest.
            now_ns: That time, or the present one [ns since epoch].
        """
        if fixed_frame != self._fixed_frame or held_ns is not None:
            self._dragging.end_all(self.markers)
            self._fixed_frame = fixed_frame
        self._listen()
        self._take_events()
        self._dragging.look(self.markers)
        held = self._grabs.items()
        self._grabs = {client: grab for client, grab in held if self._dragging.holds(client, grab.key)}
        self._outbox.send_one()
        obstacle = self._find_frames(buffer, fixed_frame, held_ns)
        drawn: list[tuple[Shape, Pose | None]] = []
        self._drawn = []
        gizmos: dict[Key, Gizmo] = {}
        for name, known in self.markers.items():
            obstacle = self._draw_marker(buffer, name, known, drawn, gizmos, held_ns) or obstacle
        fault = self._gizmos.draw({} if held_ns is not None else gizmos, self._dragging.held_gizmos)
        self.status = shown_text(self._status(held_ns) or self._shown.status or obstacle or fault, MAX_STATUS)
        return drawn

    def _status(self, held_ns: int | None) -> str:
        if not self.is_published:
            return f"nobody publishes {self.topic}"
        if self.silence or self._refusal:
            return self.silence or self._refusal
        if self._shown.needs_all and not self.markers:
            return "the server is asked for its markers"
        if held_ns is not None:
            return "the markers are those of now, and can't be dragged at an earlier time"
        return "" if self.markers else "the server has no markers"

    def _find_frames(self, buffer: Buffer, fixed_frame: str, held_ns: int | None) -> str:
        """Note where the frames of the markers are; return why one is not known."""
        self._frames.clear()
        obstacle = ""
        for name, known in self.markers.items():
            frame = known.message.header.frame_id.removeprefix("/") or fixed_frame
            try:
                base = known.base._replace(position=(0.0, 0.0, 0.0), rotation_xyzw=(0.0, 0.0, 0.0, 1.0))
                self._frames[name] = Transform(*pose_in(buffer, fixed_frame, base, held_ns)[0])
            except (TransformException, DisplayError) as error:
                thing = f"the marker {shown_text(name, 40)!r}"
                obstacle = obstacle or transform_text(error, buffer, fixed_frame, frame, held_ns, thing)
        return obstacle

    def _draw_marker(
        self,
        buffer: Buffer,
        name: str,
        known: KnownMarker,
        drawn: list[tuple[Shape, Pose | None]],
        gizmos: dict[Key, Gizmo],
        held_ns: int | None,
    ) -> str:
        """Add the shapes and the gizmos of a marker; return why one is not shown."""
        if (fixed_from_frame := self._frames.get(name)) is None:
            return ""
        obstacle = ""
        fixed_from_marker = fixed_from_frame @ known.frame_from_marker
        for placed, number in self._shown.parts_of(known):
            pose: Pose | None = None
            try:
                pose = self._pose_of(buffer, placed, fixed_from_marker, held_ns)
            except (TransformException, DisplayError) as error:
                frame = placed.frame_id.removeprefix("/")
                obstacle = transform_text(error, buffer, self._fixed_frame, frame, held_ns, "a marker")
            drawn.append((placed.shape, pose))
            self._drawn.append((name, number))
        for number, control in enumerate(known.message.controls):
            if (handle := handle_of(control)) is None:
                continue
            try:
                turn = _turn_of(control, fixed_from_frame, fixed_from_marker)
            except DisplayError as error:
                obstacle = str(error)
                continue
            place = Transform(fixed_from_marker.translation, turn.rotation_xyzw)
            gizmos[name, number] = Gizmo(handle, known.size_m, place)
        return obstacle

    def _pose_of(
        self, buffer: Buffer, placed: Placed, fixed_from_marker: Transform, held_ns: int | None
    ) -> Pose:
        """Return the pose of a shape, which is the marker's where it names no frame."""
        if placed.frame_id:
            return pose_in(buffer, self._fixed_frame, placed, held_ns)[0]
        place = fixed_from_marker @ Transform(placed.position, placed.rotation_xyzw)
        return place.translation, place.rotation_xyzw


def _turn_of(control: Any, fixed_from_frame: Transform, fixed_from_marker: Transform) -> Transform:
    """Return the rotation of a control in the fixed frame.

    Raises:
        DisplayError: a number of it is not finite.
    """
    is_fixed = control.orientation_mode == InteractiveMarkerControl.FIXED
    return (fixed_from_frame if is_fixed else fixed_from_marker) @ rotation_of(control)
