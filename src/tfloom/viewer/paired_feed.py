"""A display that needs a second topic, as a depth image the camera info beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from tfloom.rosidl.message import DecodeError
from tfloom.viewer.feed import Feed
from tfloom.viewer.shapes import DisplayError

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.displays.display import PairedDisplay
    from tfloom.viewer.displays.kinds import Kind
    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.shapes import Shape
    from tfloom.viewer.topic_log import Cursor, Entry
    from tfloom.viewer.topics import Topics

__all__ = ["PairedFeed"]


class PairedFeed(Feed):
    """What a display of two topics shows.

    Args:
        topic: The topic of its messages.
        kind: The kind of the display, a `PairedDisplay`.
        cursor: A reader of the topic.
        topics: Where the second topic is.
    """

    def __init__(self, topic: str, kind: Kind, cursor: Cursor, topics: Topics) -> None:
        self._topics = topics
        self._second_topic = ""
        self._second: Cursor | None = None
        """The reader of the second topic, as soon as somebody publishes it."""
        self._known: Entry | None = None
        """The message of the second topic that counts."""
        super().__init__(topic, kind, cursor)

    @property
    def _shown(self) -> PairedDisplay:
        return cast("PairedDisplay", self.display)

    def close(self) -> None:
        """End reading both topics; what is shown stays."""
        super().close()
        self._close_second()

    def _close_second(self) -> None:
        second, self._second, self._known = self._second, None, None
        if second is not None:
            second.close()

    def forget(self) -> None:
        """End reading, and show nothing of the messages so far, of either topic."""
        super().forget()
        self._shown.partner = None

    def draw(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, now_ns: int
    ) -> list[tuple[Shape, Pose | None]]:
        """Return the shapes to draw, by the second topic's message of the time that the page shows."""
        before = self._shown.partner, self._shown.absence
        try:
            self._look_at_second(held_ns)
        except DisplayError as error:
            self._shown.partner, self._shown.absence = None, str(error)
        if before != (self._shown.partner, self._shown.absence):
            self._begin_anew()  # the last message looks otherwise now
        return super().draw(buffer, fixed_frame, held_ns, now_ns)

    def _look_at_second(self, held_ns: int | None) -> None:
        """Let the display know what the second topic says.

        Raises:
            DisplayError: that is not known; the text says why.
        """
        topic = self._shown.partner_topic(self.topic)
        if topic != self._second_topic:  # a setting names another one
            self._close_second()
            self._second_topic, self._shown.partner = topic, None
        second = self._second = self._second or self._opened()
        entry = None if second is None else second.log.newest(held_ns)
        if entry is None:
            if self._shown.partner is None or held_ns is not None:
                self._known = None
                raise DisplayError(self._absence(is_read=second is not None))
            return  # a topic that is read again: what is shown stays until the first message
        if entry != self._known:
            self._known = entry
            self._shown.partner = self._partner_of(entry)
        elif self._shown.partner is None:
            raise DisplayError(self._shown.absence)

    def _opened(self) -> Cursor | None:
        """Return a reader of the second topic; None if nobody publishes it.

        Raises:
            DisplayError: it can't be read.
        """
        if self._topics.types().get(self._second_topic) != self._shown.partner_type:
            return None
        return self._topics.open(self._second_topic)

    def _absence(self, *, is_read: bool) -> str:
        name, topic = self._shown.partner_name, self._second_topic
        if not is_read:
            return f"nobody publishes its {name}, {topic}"
        silence = self._topics.silence(topic, self._shown.partner_type)
        return f"there is no {name} on {topic}{f': {silence}' if silence else ' yet'}"

    def _partner_of(self, entry: Entry) -> Any:
        try:
            return self._shown.partner_of(entry.message())
        except (DisplayError, DecodeError) as error:
            text = f"the {self._shown.partner_name} on {self._second_topic} can't be used: {error}"
            raise DisplayError(text) from None
