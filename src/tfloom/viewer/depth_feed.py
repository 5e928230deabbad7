"""The display of a depth image, which needs a second topic: the camera info beside the image."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.rosidl.message import DecodeError
from tfloom.viewer.displays.camera_info import INFO_TYPE, Pinhole, info_topic_of, pinhole_of
from tfloom.viewer.displays.depth_cloud import DepthCloudDisplay
from tfloom.viewer.feed import Feed
from tfloom.viewer.shapes import DisplayError

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.displays.kinds import Kind
    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.shapes import Shape
    from tfloom.viewer.topic_log import Cursor, Entry
    from tfloom.viewer.topics import Topics

__all__ = ["DepthFeed"]


class DepthFeed(Feed):
    """What a cloud of a depth image shows.

    Args:
        topic: The topic of the image.
        kind: The kind of the display.
        cursor: A reader of the topic.
        topics: Where the camera info is.
    """

    def __init__(self, topic: str, kind: Kind, cursor: Cursor, topics: Topics) -> None:
        self._topics = topics
        self._info_topic = info_topic_of(topic)
        self._infos: Cursor | None = None
        """The reader of the camera info, as soon as somebody publishes it."""
        self._info: Entry | None = None
        """The camera info that counts."""
        super().__init__(topic, kind, cursor)

    @property
    def _shown(self) -> DepthCloudDisplay:
        display = self.display
        assert isinstance(display, DepthCloudDisplay)  # noqa: S101  # for the type checker; its kind says so
        return display

    def close(self) -> None:
        """End reading both topics; what is shown stays."""
        super().close()
        infos, self._infos, self._info = self._infos, None, None
        if infos is not None:
            infos.close()

    def forget(self) -> None:
        """End reading, and show nothing of the messages so far, nor by their camera info."""
        super().forget()
        self._shown.camera = None

    def draw(
        self, buffer: Buffer, fixed_frame: str, held_ns: int | None, now_ns: int
    ) -> list[tuple[Shape, Pose | None]]:
        """Return the cloud, by the camera info of the time that the page shows."""
        before = self._shown.camera, self._shown.absence
        try:
            self._look_at_info(held_ns)
        except DisplayError as error:
            self._shown.camera, self._shown.absence = None, str(error)
        if before != (self._shown.camera, self._shown.absence):
            self._begin_anew()  # the last image is another cloud now
        return super().draw(buffer, fixed_frame, held_ns, now_ns)

    def _look_at_info(self, held_ns: int | None) -> None:
        """Let the display know the camera.

        Raises:
            DisplayError: it is not known; the text says why.
        """
        infos = self._infos = self._infos or self._opened()
        entry = None if infos is None else infos.log.newest(held_ns)
        if entry is None:
            if self._shown.camera is None or held_ns is not None:
                self._info = None
                raise DisplayError(self._absence(is_read=infos is not None))
            return  # a topic that is read again: what is shown stays until the first message
        if entry != self._info:
            self._info = entry
            self._shown.camera = self._camera_of(entry)

    def _opened(self) -> Cursor | None:
        """Return a reader of the camera info; None if nobody publishes it.

        Raises:
            DisplayError: it can't be read.
        """
        if self._topics.types().get(self._info_topic) != INFO_TYPE:
            return None
        return self._topics.open(self._info_topic)

    def _absence(self, *, is_read: bool) -> str:
        if not is_read:
            return f"nobody publishes its camera info, {self._info_topic}"
        silence = self._topics.silence(self._info_topic, INFO_TYPE)
        return f"there is no camera info on {self._info_topic}{f': {silence}' if silence else ' yet'}"

    def _camera_of(self, entry: Entry) -> Pinhole:
        try:
            return pinhole_of(entry.message())
        except (DisplayError, DecodeError) as error:
            raise DisplayError(f"the camera info on {self._info_topic} can't be used: {error}") from None
