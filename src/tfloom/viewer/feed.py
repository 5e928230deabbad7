"""A display and the messages of its topic: what it shows at a time, and why not."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, cast

from tfloom.tf2.buffer import LATEST
from tfloom.tf2.errors import TransformException
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import MAX_COORDINATE_M, shown_text
from tfloom.viewer.displays.kinds import NO_SETTINGS, Kind, make_display
from tfloom.viewer.displays.robot_model import RobotDisplay
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.replay import Replay
from tfloom.viewer.shapes import DisplayError, Placed, Shape
from tfloom.viewer.topic_log import END, Cursor, TopicLog

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.displays.display import KeepingDisplay
    from tfloom.viewer.displays.settings import Value
    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.topic_log import Entry

__all__ = ["Feed", "pose_in"]

PATIENCE_NS = 1_000_000_000
"""How long transforms may be behind a message until it is shown without them [ns]."""
MAX_SHAPES = 4000
"""Number of shapes of one display that are drawn."""
NOTHING = Cursor(TopicLog(0, lambda _: None))
"""A reader of a log that stays empty."""


class Feed:
    """What one display shows.

    Args:
        topic: Its topic.
        kind: Its kind.
        cursor: A reader of its topic.
        settings: Values for some of the kind's settings.
    """

    def __init__(
        self, topic: str, kind: Kind, cursor: Cursor, settings: Mapping[str, Value] = NO_SETTINGS
    ) -> None:
        self.topic = topic
        self.kind = kind
        self.settings = {name: value for name, value in settings.items() if name in kind.settings}
        self.status = "" if not kind.module else "no message yet"
        """What the page says of it: why it shows nothing, or not all; empty if all is shown."""
        self.has_failed = False
        self.display = make_display(kind, topic, self.settings)
        self._run = cast("int", {**kind.settings, **self.settings}.get("history", 1))
        """How many messages the display shows that has not all of them."""
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
        self.read(cursor)

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
                    partial(make_display, self.kind, self.topic, self.settings),
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
        self._last = self._failed_at = None
        self.has_failed = False
        self._fault = self._frame = ""
        if self.display is not None:
            self.display.clear()
        self.status = "" if not self.kind.module else "no message yet"

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all."""
        return self._cursor.log.newest(stamp_ns)

    def fail(self, error: Exception) -> None:
        """Show nothing until the next message, because of a fault."""
        self.has_failed = True
        self._failed_at = None
        with contextlib.suppress(Exception):  # that may be what failed
            self._failed_at = self.newest(self._held_ns)
        self.status = shown_text(f"it can't be shown: {fault_text(error)}")

    def choose(self, choice: str) -> None:
        """Choose one of the display's choices, and show the last message anew."""
        if self.display is not None and choice in self.display.choices:
            self.display.choice = choice
            self._last = None

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
        if is_empty:
            self.status = shown_text(self._fault or "no message at this time")
            return []
        try:
            placed = display.shapes(now_ns)
        except DisplayError as error:
            self.status = shown_text(str(error))
            return []
        if placed and self._last is not None and placed[0].stamp_ns == self._last.stamp_ns:
            self._frame = placed[0].frame_id.removeprefix("/")
        fault = self._fault or (display.status if isinstance(display, RobotDisplay) else "")
        if len(placed) > MAX_SHAPES:
            fault = fault or f"{len(placed)} shapes, of which {MAX_SHAPES} are shown"
            placed = placed[:MAX_SHAPES]
        drawn, obstacle = self._place(buffer, fixed_frame, held_ns, placed)
        self.status = shown_text(fault or obstacle)
        return drawn

    def frames(self) -> list[str]:
        """Return the frame of each shape of a robot, which a click on it selects; none of what can't be clicked."""
        if not isinstance(self.display, RobotDisplay):
            return []
        return [placed.frame_id for placed in self._poses_of[1]]

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
        display.clear()
        self._last, self._fault = entry, ""
        if entry is None:
            return
        for one in self._cursor.log.run(entry, self._run) if self._run > 1 else [entry]:
            self._fault = ""
            try:
                display.take(one.message(), one.stamp_ns)
            except Exception as error:  # of one message: the next one may be good
                self._fault = fault_text(error)

    def _place(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, placed: list[Placed]
    ) -> tuple[list[tuple[Shape, Pose | None]], str]:
        if self._poses_of[0] != fixed_frame or self._poses_of[1] is not placed:
            self._poses_of = fixed_frame, placed
            self._poses.clear()
        obstacle = ""
        drawn: list[tuple[Shape, Pose | None]] = []
        for number, part in enumerate(placed):
            pose = self._poses.get(number)
            if pose is None:
                try:
                    pose, is_exact = pose_in(buffer, fixed_frame, part, held_ns)
                    if is_exact:
                        self._poses[number] = pose
                except (TransformException, DisplayError) as error:
                    obstacle = obstacle or fault_text(error)
            drawn.append((part.shape, pose))
        return drawn, obstacle


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
