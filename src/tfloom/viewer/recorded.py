"""The viewer of a recording: its transforms, and its messages at any time."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.bag.errors import BagError
from tfloom.bag.message_classes import class_of
from tfloom.bag.opening import open_bag
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.sources import open_path
from tfloom.viewer.history import START, Entry, Logged
from tfloom.viewer.program import Viewer
from tfloom.viewer.shapes import DisplayError

if TYPE_CHECKING:
    from tfloom.bag.bag import Bag
    from tfloom.rosidl.message import Message
    from tfloom.viewer.history import MessageLog, Messages, Place
    from tfloom.viewer.topics import Follower

__all__ = ["RecordedTopics", "recorded_viewer"]

WINDOWS_NS = (500_000_000, 5_000_000_000, 60_000_000_000)
"""How far before a time its last message is looked for, in turn; then from the start [ns]."""
STEPS = 200
"""Number of parts of a recording that are read one after the other for a plot."""
READ_S = 0.005
"""How long a recording is read for one picture [s]; one part is read at least."""
MAX_STEP_NS = 10_000_000_000
"""Length of the longest of these parts [ns]."""


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
        message_class = self.message_class(topic)
        return _RecordedMessages(self._bag, topic), lambda data: cdr.decode(message_class, data)

    def message_class(self, topic: str) -> type[Message]:
        """Return the class of a topic's messages.

        Raises:
            DisplayError: there is no such topic, or its type has no definition, here or in the recording.
        """
        if topic not in self._types:
            raise DisplayError(f"the recording has no topic {topic}")
        try:
            message_class: type[Message] = class_of(self._bag.path, self._bag.topic(topic))
        except BagError as error:
            raise DisplayError(str(error)) from None
        return message_class

    def follow(self, topic: str) -> Follower:
        """Begin to read all messages of a topic, a part for each picture.

        Raises:
            DisplayError: as `message_class`.
        """
        return _RecordedFollower(self._bag, topic, self.message_class(topic))

    def close(self, topic: str) -> None:
        """Do nothing: files are open while they are read only."""

    def poll(self) -> None:
        """Do nothing: all messages are there."""


class _RecordedFollower:
    """Reads all messages of one topic of a recording, a part at a time, so that pages are drawn meanwhile."""

    def __init__(self, bag: Bag, topic: str, message_class: type[Message]) -> None:
        self._bag = bag
        self._topic = topic
        self._class = message_class
        self._next_ns = bag.start_ns
        self._step_ns = (bag.end_ns - bag.start_ns) // STEPS + 1

    def take(self) -> Iterable[Entry]:
        end_s = time.monotonic() + READ_S
        while self._next_ns <= self._bag.end_ns:
            start_ns, self._next_ns = self._next_ns, self._next_ns + self._step_ns
            # The last nanosecond is of the next part.
            yield from _read_entries(self._bag, self._topic, start_ns, self._next_ns - 1)
            if time.monotonic() > end_s:
                return

    def decode(self, data: bytes) -> Any:
        return cdr.decode(self._class, data)

    def close(self) -> None:
        """Do nothing: files are open while they are read only."""


def _read_entries(bag: Bag, topic: str, start_ns: int, end_ns: int) -> list[Entry]:
    try:
        return [
            Entry(message.log_time_ns, message.data)
            for message in bag.messages(topic, max(0, start_ns), end_ns)
        ]
    except BagError:
        return []  # a damaged part of the recording has no messages


class _RecordedMessages:
    """The messages of one topic, by the times at which they were recorded."""

    def __init__(self, bag: Bag, topic: str) -> None:
        self._bag = bag
        self._topic = topic
        self._found: tuple[int, int, Entry | None] | None = None
        """The last answer, and from when to when it holds [ns since epoch]."""

    def log(self) -> MessageLog:
        """Return the messages by the times at which they were recorded."""
        return _RecordedLog(self._bag, self._topic)

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message up to a time [ns since epoch]; None: the last of all."""
        end_ns = self._bag.end_ns if stamp_ns is None else stamp_ns
        if self._found is not None and self._found[0] <= end_ns < self._found[1]:
            return self._found[2]
        for window_ns in (*WINDOWS_NS, end_ns):
            # A little beyond the time, because the message that follows says until when the answer holds.
            entries = _read_entries(self._bag, self._topic, end_ns - window_ns, end_ns + WINDOWS_NS[0])
            newest = next((entry for entry in reversed(entries) if entry.stamp_ns <= end_ns), None)
            if newest is not None or window_ns == end_ns:
                after_ns = next(
                    (entry.stamp_ns for entry in entries if entry.stamp_ns > end_ns), end_ns + WINDOWS_NS[0]
                )
                self._found = end_ns if newest is None else newest.stamp_ns, after_ns, newest
                return newest
        return None


class _RecordedLog:
    """The messages of one topic, by the times at which they were recorded, read a part at a time."""

    is_whole = True

    def __init__(self, bag: Bag, topic: str) -> None:
        self._bag = bag
        self._topic = topic
        self._step_ns = min((bag.end_ns - bag.start_ns) // STEPS + 1, MAX_STEP_NS)
        self._parts: dict[int, list[Logged]] = {}
        """The messages of the two parts that were read last, by their numbers: a time at their border needs both."""

    def after(self, place: Place, stamp_ns: int | None) -> Iterator[Logged]:
        end_ns = self._bag.end_ns if stamp_ns is None else min(stamp_ns, self._bag.end_ns)
        first = max(0, (place[0] - self._bag.start_ns) // self._step_ns)
        for number in range(first, (end_ns - self._bag.start_ns) // self._step_ns + 1):
            for logged in self._read(number):
                if logged.from_ns > end_ns:
                    return
                if logged.place > place:
                    yield logged

    def _read(self, number: int) -> list[Logged]:
        if number not in self._parts:
            start_ns = self._bag.start_ns + number * self._step_ns
            entries = _read_entries(self._bag, self._topic, start_ns, start_ns + self._step_ns - 1)
            # Several may be of one time, which are all in one part.
            self._parts[number] = [
                Logged((entry.stamp_ns, index), entry.stamp_ns, entry) for index, entry in enumerate(entries)
            ]
            if len(self._parts) > 2:
                del self._parts[next(iter(self._parts))]
        return self._parts[number]

    def droppable(self) -> Place:
        return START

    def drop(self, place: Place) -> None:
        """Do nothing: messages are read anew."""


@contextmanager
def recorded_viewer(path: Path, *, topics: tuple[str, str], fixed_frame: str = "") -> Iterator[Viewer]:
    """Open a viewer of a recording, or of a file of static transforms, for the block.

    Args:
        path: The recording, or a file that ends in .yaml.
        topics: The topics of moving and of static transforms.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.

    Raises:
        BagError: it is not a recording, or has no transforms.
        StaticFileError: it is not a file of static transforms.
        OSError: it can't be read.
    """
    buffer = Buffer(None)
    buffer.set_log_callback(None)
    source = open_path(path, buffer=buffer, topics=topics)
    with open_bag(path) as bag, Viewer(source, RecordedTopics(bag), fixed_frame=fixed_frame) as viewer:
        yield viewer
