"""A display and the messages of its topic: what it shows at a time, and why not."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from tfloom.tf2.buffer import LATEST
from tfloom.tf2.errors import TransformException
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import MAX_COORDINATE_M, shown_text
from tfloom.viewer.displays.kinds import Kind, make_display
from tfloom.viewer.displays.markers import MarkerDisplay
from tfloom.viewer.displays.robot_model import RobotDisplay
from tfloom.viewer.displays.settings import Value, usual_values
from tfloom.viewer.obstacles import (
    MAX_STATUS,
    PATIENCE_NS,
    lag_text,
    message_text,
    thing_of,
    transform_text,
)
from tfloom.viewer.page_command import PageError, fault_text
from tfloom.viewer.replay import Replay
from tfloom.viewer.shapes import Copies, DisplayError, Placed, Points, Shape
from tfloom.viewer.topic_log import END, Cursor, TopicLog

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.displays.display import Display, KeepingDisplay
    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.topic_log import Entry

__all__ = ["Feed", "pose_in"]

MAX_SHAPES = 4000
"""Number of shapes of one display that are drawn."""
MAX_RUN = 5000
"""Number of messages that are looked at for one picture."""
MAX_RUN_POINTS = 1_000_000
"""Number of points of several messages that are drawn, of the newest ones."""
NOTHING_SET: Mapping[str, Value] = MappingProxyType({})
NOTHING = Cursor(TopicLog(0, lambda _: None))
"""A reader of a log that stays empty."""


class Feed:
    """What one display shows.

    Args:
        topic: Its topic.
        kind: Its kind.
        cursor: A reader of its topic; None: a display without one.
        settings: Values for some of the kind's settings.
    """

    def __init__(
        self,
        topic: str,
        kind: Kind,
        cursor: Cursor | None = None,
        settings: Mapping[str, Value] = NOTHING_SET,
    ) -> None:
        self.topic = topic
        self.kind = kind
        self.settings = {name: value for name, value in settings.items() if name in kind.settings}
        """The settings that were set."""
        self._values = {**usual_values(kind.settings), **self.settings}
        """All of them, as the display has them."""
        self.status = self._first_status
        """What the page says of it: why it shows nothing, or not all; empty if all is shown."""
        self.type_name = ""
        """The type of its messages; empty without a topic."""
        self.silence = ""
        """Why no messages come; empty if nothing keeps them away. The reader of the graph sets it."""
        self.is_published = True
        """Whether somebody publishes the topic; set with `silence`."""
        self.has_failed = False
        self.display = make_display(kind, topic, self._values)
        self._run: list[_Taken] = []
        """What is shown of a display that shows several single messages."""
        self._placed_of, self._placed = self._run, list[Placed]()
        self._last: Entry | None = None
        self._held_ns: int | None = None
        """The time that was shown last [ns since epoch]; None: the newest."""
        self._failed_at: Entry | None = None
        """The newest message of that time when the display failed."""
        self._fault = ""
        self._frame = ""
        """The frame of the last message that has its own stamp; empty before one."""
        self._poses: dict[int, Pose] = {}
        """Poses of shapes that have a stamp, by the shape's place: they are looked up once."""
        self._poses_of: tuple[str, list[Placed]] = "", []
        self._replay: Replay | None = None
        self._cursor: Cursor = NOTHING
        if cursor is not None:
            self.read(cursor)

    @property
    def _first_status(self) -> str:
        return "no message yet" if self.kind.module and self.kind.has_topic else ""

    @property
    def is_plain(self) -> bool:
        """Whether nothing of it was set or chosen."""
        return not self.settings and (self.display is None or not self.display.choice)

    def read(self, cursor: Cursor) -> None:
        """Show what another reader has from now on, and end the one before.

        What is shown stays until the first message has come, unless a time is held at which the new one has none.
        """
        try:
            base = self._replay.base() if self._replay is not None else None
            if self.display is None or not self.display.keeps_all:
                cursor.number = END  # the history is enough
            else:
                make = cast(
                    "Callable[[], KeepingDisplay]",
                    partial(make_display, self.kind, self.topic, self._values),
                )
                self._replay = Replay(make, cursor, base)
        except BaseException:
            cursor.close()
            raise
        self._cursor.close()
        self._cursor = cursor

    def close(self) -> None:
        """End reading; what is shown stays."""
        self._cursor.close()

    def forget(self) -> None:
        """End reading, show nothing of the messages so far, and nothing until `read` is called."""
        self.close()
        self._cursor = NOTHING
        self._replay = None
        self._run = []
        self._last = self._failed_at = None
        self.has_failed = False
        self._fault = self._frame = ""
        if self.display is not None:
            self.display.clear()
        self.status = self._first_status

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all."""
        return self._cursor.log.newest(stamp_ns)

    def fail(self, error: Exception) -> None:
        """Show nothing until the next message, because of a fault."""
        self.has_failed = True
        self._failed_at = None
        with contextlib.suppress(Exception):  # that may be what failed
            self._failed_at = self.newest(self._held_ns)
        self.status = shown_text(f"it can't be shown: {fault_text(error)}", MAX_STATUS)

    def choose(self, choice: str) -> None:
        """Choose one of the display's choices, and show the last message anew."""
        if self.display is not None and choice in self.display.choices:
            self.display.choice = choice
            self._begin_anew()

    def set(self, name: str, value: Value | None) -> None:
        """Set one of the kind's settings, and show the messages anew; None: as it usually is."""
        usual = self.kind.settings[name].usual
        self._values[name] = usual if value is None else value
        if self._values[name] == usual:
            self.settings.pop(name, None)
        else:
            self.settings[name] = self._values[name]
        if name == "depth":
            self._cursor.depth = self.depth
        self._begin_anew()

    @property
    def depth(self) -> int:
        """Number of messages of its topic that may wait to be taken; 0: as is usual for it."""
        return int(self._values.get("depth", 0))

    def _begin_anew(self) -> None:
        if isinstance(self.display, RobotDisplay):
            self.display.clear()
        self._last, self._run = None, []
        self.has_failed = False

    @property
    def values(self) -> dict[str, Value]:
        """The value of each of the kind's settings."""
        return self._values

    def parts(self) -> list[str]:
        """Return the names of the parts that may be hidden, as namespaces or links."""
        return self.display.parts() if isinstance(self.display, (MarkerDisplay, RobotDisplay)) else []

    def draw(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, now_ns: int
    ) -> list[tuple[Shape, Pose | None]]:
        """Return the shapes to draw, each with its pose in the fixed frame; None where that is not known.

        Args:
            buffer: The transforms.
            fixed_frame: The fixed frame.
            held_ns: The time that the page shows [ns since epoch]; None: the newest.
            now_ns: That time, or the present one [ns since epoch].
        """
        display = self.display
        if display is None:
            self.status = shown_text(self.silence, MAX_STATUS)
            return []  # the page asks for images itself
        self._held_ns = held_ns
        # Also after a failure, because the log keeps messages only for so long.
        known = self._replay.show(held_ns) if self._replay is not None else None
        if self.has_failed and self._failed_at == self.newest(held_ns):
            return []
        self.has_failed = False
        if known is not None:
            self.display = display = known.display
            self._fault, is_empty = known.fault, not known.messages
            if known.cursor.is_behind:
                self._fault = f"{known.messages} messages are read so far, and more follow"
        else:
            self._take(buffer, fixed_frame, held_ns)
            is_empty = self._last is None
        if is_empty and self.kind.has_topic:
            absence = "no message at this time" if self.is_published else "nobody publishes it"
            self.status = shown_text(self._fault or self.silence or absence, MAX_STATUS)
            return []
        try:
            placed = self._shapes(display, now_ns)
        except DisplayError as error:
            self.status = shown_text(str(error), MAX_STATUS)
            return []
        if self._last is not None:
            stamp_ns = self._last.stamp_ns
            newest = next((part.frame_id for part in placed if part.stamp_ns == stamp_ns), self._frame)
            self._frame = newest.removeprefix("/")
        fault = self._fault or (display.status if isinstance(display, RobotDisplay) else "")
        if len(placed) > MAX_SHAPES:
            fault = fault or f"{len(placed)} shapes, of which {MAX_SHAPES} are shown"
            placed = placed[:MAX_SHAPES]
        drawn, obstacle = self._place(buffer, fixed_frame, held_ns, placed)
        self.status = shown_text(self.silence or fault or obstacle, MAX_STATUS)
        return drawn

    def _shapes(self, display: Display, now_ns: int) -> list[Placed]:
        if self._replay is not None or not self._shows_several:
            return display.shapes(now_ns)
        if self._placed_of is not self._run:  # the same list as long as nothing comes
            self._placed_of = self._run
            self._placed = [placed for taken in self._run for placed in taken.placed]
        return self._placed

    def frames(self) -> list[str]:
        """Return the frame of each shape of a robot, which a click on it selects; none of what can't be clicked."""
        if not isinstance(self.display, RobotDisplay):
            return []
        return [placed.frame_id for placed in self._poses_of[1]]

    @property
    def on_click(self) -> Callable[[int, Any], None] | None:
        """What takes the number of a shape that is clicked and viser's event, on a thread of viser; None: nothing."""
        return None

    def on_drag(self, _index: int) -> Callable[[Any], Any] | None:
        """Return what takes viser's events of a drag of a shape that was drawn; None for one that isn't dragged."""
        return None

    def choose_entry(self, client: int, command: Mapping[str, Any]) -> None:
        """Choose an entry of the menu of an interactive marker.

        Args:
            client: Viser's number of the page's scene.
            command: What the page asks for: `marker`, `control` and `entry`.

        Raises:
            PageError: it can't be chosen.
        """
        raise PageError(f"{shown_text(self.topic)} has no menus")

    @property
    def frame_id(self) -> str:
        """The frame of the first shape that is shown; empty where there is none."""
        return next((placed.frame_id.removeprefix("/") for placed in self._poses_of[1]), "")

    def _newest(self, buffer: Buffer, fixed_frame: str, held_ns: int | None) -> Entry | None:
        """Return the message to show: the last one that the transforms have reached.

        A message comes before the transforms of its stamp, and would stand where its frame was earlier until they
        come: a scan of a robot that turns would be turned. If they stay away, the newest one is shown all the same.
        """
        newest = self.newest(held_ns)
        if newest is None or newest == self._last or held_ns is not None or self._frame in {"", fixed_frame}:
            return newest
        try:
            reached_ns = buffer.lookup(fixed_frame, self._frame).stamp_ns  # 0: nothing moves between them
        except TransformException:
            return newest
        if not 0 < reached_ns < newest.stamp_ns <= reached_ns + PATIENCE_NS:
            return newest
        reached = self.newest(reached_ns)
        if reached is None or (self._last is not None and reached.stamp_ns < self._last.stamp_ns):
            return self._last
        return reached

    def _take(self, buffer: Buffer, fixed_frame: str, held_ns: int | None) -> None:
        """Give the display the last message up to a time, or the last ones."""
        display = self.display
        assert display is not None  # noqa: S101  # for the type checker; the caller has asked
        entry = self._newest(buffer, fixed_frame, held_ns)
        # Of a topic that is read again, nothing has come yet.
        if entry == self._last or (entry is None and held_ns is None):
            return
        self._last, self._fault = entry, ""
        if entry is None or not self._shows_several:
            # Pages have the meshes of a robot, whose description may come again as it was.
            if entry is None or not isinstance(display, RobotDisplay):
                display.clear()
            if entry is not None:
                self._fault = _given(display, entry, self.kind.label)
            return
        self._run = self._taken(display, self._entries_with(entry))
        self._fault = next(taken.fault for taken in self._run if taken.key == _key(entry))

    @property
    def _shows_several(self) -> bool:
        return bool(self._values.get("history", 1) > 1 or self._values.get("decay_s", 0.0) > 0.0)

    def _entries_with(self, entry: Entry) -> list[Entry]:
        """Return the messages to show with the newest one, that one last."""
        if "decay_s" in self._values:
            return self._cursor.log.run(entry, MAX_RUN, int(self._values["decay_s"] * 1e9))
        # Of odometry, messages that have not moved are left out, and so more are looked at.
        count = MAX_RUN if "position_tolerance" in self._values else self._values["history"]
        return self._cursor.log.run(entry, count)

    def _taken(self, display: Display, entries: list[Entry]) -> list[_Taken]:
        """Return what is shown of some messages, of which the last one is shown in any case.

        What was shown before keeps its place among the shapes: the page has it already.
        """
        before = {taken.key: taken for taken in self._run}
        now = {}
        for entry in entries:
            key = _key(entry)
            now[key] = before.get(key) or _taken(display, entry, self.kind.label)
        kept = {taken.key: taken for taken in self._thinned(list(now.values()))}
        fresh = [taken for key, taken in kept.items() if key not in before]
        places: list[_Taken] = []
        for taken in self._run:
            if taken.key in kept:
                places.append(taken)
            elif fresh:
                places.append(fresh.pop(0))
        return places + fresh

    def _thinned(self, run: list[_Taken]) -> list[_Taken]:
        """Return the newest ones of a run that may be shown, the oldest first."""
        if "position_tolerance" in self._values:
            run = _moved(run, self._values["position_tolerance"], self._values["angle_tolerance"])
        run = run[-self._values.get("history", MAX_RUN) :]
        points = 0
        for number, taken in enumerate(reversed(run)):
            points += taken.points
            if number and points > MAX_RUN_POINTS:
                return run[-number:]
        return run

    def _place(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, placed: list[Placed]
    ) -> tuple[list[tuple[Shape, Pose | None]], str]:
        if self._poses_of[0] != fixed_frame or self._poses_of[1] is not placed:
            self._poses_of = fixed_frame, placed
            self._poses.clear()
        obstacle, lag = "", None
        thing = thing_of(self.kind.label)
        drawn: list[tuple[Shape, Pose | None]] = []
        for number, part in enumerate(placed):
            pose = self._poses.get(number)
            if pose is None:
                try:
                    pose, is_exact = pose_in(buffer, fixed_frame, part, held_ns)
                    if is_exact:
                        self._poses[number] = pose
                    elif lag is None and part.stamp_ns > 0:
                        lag = lag_text(buffer, fixed_frame, part, thing)
                except (TransformException, DisplayError) as error:
                    frame = part.frame_id.removeprefix("/") or fixed_frame
                    obstacle = obstacle or transform_text(error, buffer, fixed_frame, frame, held_ns, thing)
            drawn.append((part.shape, pose))
        return drawn, obstacle or lag or ""


class _Taken(NamedTuple):
    """What is shown of one message."""

    key: tuple[int, bytes]
    placed: list[Placed]
    fault: str

    @property
    def points(self) -> int:
        """Number of points."""
        return sum(
            len(part.shape.positions) for part in self.placed if isinstance(part.shape, (Points, Copies))
        )


def _key(entry: Entry) -> tuple[int, bytes]:
    return entry.stamp_ns, entry.data


def _given(display: Display, entry: Entry, label: str) -> str:
    """Give a display of a kind a message; return why it can't be shown, or an empty text."""
    try:
        display.take(entry.message(), entry.stamp_ns)
    except Exception as error:  # of one message: the next one may be good
        return message_text(error, label)
    return ""


def _taken(display: Display, entry: Entry, label: str) -> _Taken:
    display.clear()
    fault = _given(display, entry, label)
    return _Taken(_key(entry), [] if fault else list(display.shapes(entry.stamp_ns)), fault)


def _moved(run: list[_Taken], position_m: float, angle_rad: float) -> list[_Taken]:
    """Return the first pose of a run, those that have moved or turned since the one before, and the last one."""
    kept: list[_Taken] = []
    for taken in run:
        if not kept or not kept[-1].placed or not taken.placed:
            kept.append(taken)
            continue
        before, now = kept[-1].placed[0], taken.placed[0]
        dot = sum(a * b for a, b in zip(before.rotation_xyzw, now.rotation_xyzw, strict=True))
        turned_rad = 2.0 * math.acos(min(abs(dot), 1.0))
        if math.dist(before.position, now.position) >= position_m or turned_rad >= angle_rad:
            kept.append(taken)
    return kept if not run or kept[-1] is run[-1] else [*kept, run[-1]]


def pose_in(buffer: Buffer, fixed_frame: str, placed: Placed, held_ns: int | None) -> tuple[Pose, bool]:
    """Return a shape's pose in the fixed frame, and whether it is that of its stamp, which stays.

    A stamp that the transforms have not reached yet, or have left behind, counts as the time that the page shows: a
    viewer shows what it can.

    Raises:
        TransformException: the frames are not connected.
        DisplayError: there are no frames, or it is further away than a page can compute with.
    """
    if not fixed_frame:
        raise DisplayError("there are no frames yet")
    frame = placed.frame_id.removeprefix("/") or fixed_frame
    view_ns = LATEST if held_ns is None else held_ns
    is_exact = False
    fixed_from_frame = None
    if placed.stamp_ns > 0:
        try:
            fixed_from_frame = buffer.lookup(fixed_frame, frame, placed.stamp_ns)
            is_exact = True
        except TransformException:
            pass
    if fixed_from_frame is None:
        try:
            fixed_from_frame = buffer.lookup(fixed_frame, frame, view_ns)
        except TransformException:
            # Nothing is published of the fixed frame, or of a world, and so everything in it is where it says.
            if frame != fixed_frame and not (frame == "world" and not buffer.has_frame("world")):
                raise
    fixed_from_shape = Transform(placed.position, placed.rotation_xyzw)
    if fixed_from_frame is not None:
        fixed_from_shape = fixed_from_frame.transform @ fixed_from_shape
    if not all(abs(part) < MAX_COORDINATE_M for part in fixed_from_shape.translation):
        raise DisplayError(f"it is further than {MAX_COORDINATE_M:g} m from {fixed_frame}")
    return (fixed_from_shape.translation, fixed_from_shape.rotation_xyzw), is_exact
