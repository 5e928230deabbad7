"""The viewer of a recording: its transforms, and its messages at any time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.bag.errors import BagError
from tfloom.bag.message_classes import class_of
from tfloom.bag.opening import open_bag
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.sources import open_path
from tfloom.viewer.history import Entry
from tfloom.viewer.program import Viewer
from tfloom.viewer.shapes import DisplayError

if TYPE_CHECKING:
    from tfloom.bag.bag import Bag
    from tfloom.viewer.history import Messages

__all__ = ["RecordedTopics", "recorded_viewer"]

WINDOWS_NS = (500_000_000, 5_000_000_000, 60_000_000_000)
"""How far before a time its last message is looked for, in turn; then from the start [ns]."""
MAX_ENTRIES = 500
"""Number of messages up to a time that a display gets, if all matter to it."""


class RecordedTopics:
    """The topics of a recording. One thread may use it.

    Args:
        bag: The recording.
    """

    def __init__(self, bag: Bag) -> None:
        self._bag = bag
        self._types = {
            topic.name: topic.type for topic in bag.topics.values() if topic.serialization_format == "cdr"
        }

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic, by its name."""
        return self._types

    def open(self, topic: str) -> tuple[Messages, Callable[[bytes], Any]]:
        """Return the messages of a topic, and the function that decodes one.

        Raises:
            DisplayError: its type has no definition, here or in the recording.
        """
        try:
            message_class = class_of(self._bag.path, self._bag.topic(topic))
        except BagError as error:
            raise DisplayError(str(error)) from None
        return _RecordedMessages(self._bag, topic), lambda data: cdr.decode(message_class, data)

    def close(self, topic: str) -> None:
        """Do nothing: files are open while they are read only."""

    def poll(self) -> None:
        """Do nothing: all messages are there."""


class _RecordedMessages:
    """The messages of one topic, by the times at which they were recorded."""

    def __init__(self, bag: Bag, topic: str) -> None:
        self._bag = bag
        self._topic = topic
        self._found: tuple[int, int, list[Entry]] | None = None
        """The last answer, and from when to when it holds [ns since epoch]."""

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message up to a time [ns since epoch]; None: the last of all."""
        entries = self.until(stamp_ns)
        return entries[-1] if entries else None

    def until(self, stamp_ns: int | None) -> Sequence[Entry]:
        """Return messages up to a time, by their times: at least the last one, at most `MAX_ENTRIES`."""
        end_ns = self._bag.end_ns if stamp_ns is None else stamp_ns
        if self._found is not None and self._found[0] <= end_ns < self._found[1]:
            return self._found[2]
        for window_ns in (*WINDOWS_NS, end_ns):
            # A little beyond the time, because the message that follows says until when the answer holds.
            entries = self._read(end_ns - window_ns, end_ns + WINDOWS_NS[0])
            until = [entry for entry in entries if entry.stamp_ns <= end_ns][-MAX_ENTRIES:]
            if until or window_ns == end_ns:
                after_ns = next(
                    (entry.stamp_ns for entry in entries if entry.stamp_ns > end_ns), end_ns + WINDOWS_NS[0]
                )
                begin_ns = until[-1].stamp_ns if until else end_ns
                self._found = begin_ns, after_ns, until
                return until
        return []

    def _read(self, start_ns: int, end_ns: int) -> list[Entry]:
        try:
            return [
                Entry(message.log_time_ns, message.data)
                for message in self._bag.messages(self._topic, max(0, start_ns), end_ns)
            ]
        except BagError:
            return []  # a damaged part of the recording has no messages


@contextmanager
def recorded_viewer(path: Path, *, topics: tuple[str, str], fixed_frame: str = "") -> Iterator[Viewer]:
    """Open a viewer of a recording, or of a file of static transforms, for the block.

    Args:
        path: The recording, or a file that ends in .yaml.
        topics: The topics of moving and of static transforms.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.

    Raises:
        BagError: it is no recording, or has no transforms.
        StaticFileError: it is no file of static transforms.
        OSError: it can't be read.
    """
    buffer = Buffer(None)
    buffer.set_log_callback(None)
    source = open_path(path, buffer=buffer, topics=topics)
    with open_bag(path) as bag, Viewer(source, RecordedTopics(bag), fixed_frame=fixed_frame) as viewer:
        yield viewer
