"""The viewer of a recording: its transforms, and its messages at any time."""

from __future__ import annotations

import bisect
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.bag.errors import BagError
from tfloom.bag.message_classes import class_of
from tfloom.bag.opening import open_bag
from tfloom.bag.tf_frames import TF_TYPES
from tfloom.common.terminal import report, shown_part
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.recorded import observe_recorded
from tfloom.tf2_tools.watch.sources import Still, open_path
from tfloom.viewer.frames import Span
from tfloom.viewer.program import Viewer
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import RUN_NS, Cursor, Entry

if TYPE_CHECKING:
    from tfloom.bag.bag import Bag
    from tfloom.rosidl.message import Message

__all__ = ["RecordedLog", "RecordedTopics", "recorded_viewer"]

WINDOWS_NS = (500_000_000, 5_000_000_000, 60_000_000_000)
"""How far before a time its last message is looked for, in turn; then from the start [ns]."""
STEPS = 200
"""Number of parts in which a recording is read."""
MAX_STEP_NS = 10_000_000_000
"""Length of the longest of these parts [ns]."""
MAX_RUN_BYTES = 256 * 1024 * 1024
"""Size of the messages that are shown together [bytes]."""
MAX_KEPT_BYTES = 64 * 1024 * 1024
"""Size of the largest part that is kept [bytes]."""
MAX_NAMES = 5
"""Number of topics that are named."""
LEFT_OUT = (
    "{path} is of ROS 1: its transforms are shown, and not {names}. `pip install rosbags` has rosbags-convert, which "
    "makes a recording of ROS 2 of it"
)
INDEX_BITS = 32
"""A message's number has that of its part, and in so many bits its index there."""


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

    def open(self, topic: str, depth: int = 0) -> Cursor:
        """Return a reader of a topic, of which no message is ever lost, whatever the depth.

        Raises:
            DisplayError: its type has no definition, here or in the recording.
        """
        return Cursor(RecordedLog(self._bag, topic, partial(cdr.decode, self.message_class(topic))))

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

    def silence(self, topic: str, type_name: str) -> str:
        """Return an empty text: nothing keeps recorded messages away."""
        return ""

    def poll(self) -> None:
        """Do nothing: all messages are there."""

    def begin_anew(self) -> None:
        """Do nothing: the time of a recording is that of its messages."""


class RecordedLog:
    """The messages of one topic, by the times at which they were recorded, read a part at a time.

    Args:
        bag: The recording.
        topic: The topic.
        decode: Returns the message of an entry's bytes.
    """

    is_whole = True
    first = 0

    def __init__(self, bag: Bag, topic: str, decode: Callable[[bytes], Any]) -> None:
        self._bag = bag
        self._topic = topic
        self._decode = decode
        self._step_ns = min((bag.end_ns - bag.start_ns) // STEPS + 1, MAX_STEP_NS)
        self._parts: dict[int, list[Entry]] = {}
        """The messages of the two parts that were read last, by their numbers: a time at their border needs both.
        Larger ones than `MAX_KEPT_BYTES` are read again."""
        self._found: tuple[int, int, Entry | None] | None = None
        """The last answer of `newest`, and from when to when it holds [ns since epoch]."""
        self._last_run: tuple[int, int, list[Entry]] = 0, -1, []
        """The last answer of `run`, and from when to when it is [ns since epoch]."""

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message up to a time [ns since epoch]; None: the last of all."""
        end_ns = self._bag.end_ns if stamp_ns is None else stamp_ns
        if self._found is not None and self._found[0] <= end_ns < self._found[1]:
            return self._found[2]
        for window_ns in (*WINDOWS_NS, end_ns):
            # A little beyond the time, because the message that follows says until when the answer holds.
            entries = self._read(0, end_ns - window_ns, end_ns + WINDOWS_NS[0])
            newest = next((entry for entry in reversed(entries) if entry.stamp_ns <= end_ns), None)
            if newest is not None or window_ns == end_ns:
                after_ns = next(
                    (entry.stamp_ns for entry in entries if entry.stamp_ns > end_ns), end_ns + WINDOWS_NS[0]
                )
                self._found = end_ns if newest is None else newest.stamp_ns, after_ns, newest
                return newest
        return None

    def run(self, entry: Entry, count: int, length_ns: int = RUN_NS) -> list[Entry]:
        """Return up to so many messages of a length of time that end with this one, in the order of their times.

        As the time goes on, what was read before is not read again; the oldest are left out above `MAX_RUN_BYTES`.
        """
        start_ns, end_ns = max(0, entry.stamp_ns - length_ns), entry.stamp_ns
        before_ns, read_ns, kept = self._last_run
        if before_ns <= start_ns <= read_ns <= end_ns:
            entries = [
                *(one for one in kept if one.stamp_ns >= start_ns),
                *self._read(0, read_ns + 1, end_ns),
            ]
        else:
            entries = self._read(0, start_ns, end_ns)
        size = 0
        for number, one in enumerate(reversed(entries)):
            size += len(one.data)
            if number >= count or (number and size > MAX_RUN_BYTES):
                start_ns, entries = entries[-number].stamp_ns, entries[-number:]
                break
        self._last_run = start_ns, end_ns, entries
        return entries or [entry]

    def parts(self, number: int, until_ns: int | None) -> Iterator[tuple[int, list[Entry]]]:
        """Yield the messages behind a place, in parts; the place has the number of its part above `INDEX_BITS`."""
        end_ns = self._bag.end_ns if until_ns is None else min(until_ns, self._bag.end_ns)
        for part in range((number + 1) >> INDEX_BITS, (end_ns - self._bag.start_ns) // self._step_ns + 1):
            first, next_ns = part << INDEX_BITS, self._bag.start_ns + (part + 1) * self._step_ns
            entries = self._part(part, first, next_ns)
            end = bisect.bisect_right(entries, end_ns, key=lambda entry: entry.stamp_ns)
            place = first + end if next_ns > end_ns else (part + 1) << INDEX_BITS
            yield place - 1, entries[max(0, number + 1 - first) : end]

    def _part(self, part: int, first: int, next_ns: int) -> list[Entry]:
        """Return the messages of a part, which is kept unless it is large: images of seconds would fill the memory."""
        if (kept := self._parts.get(part)) is not None:
            return kept
        # Several may be of one time, which are all in one part.
        entries = self._read(first, next_ns - self._step_ns, next_ns - 1)
        if sum(len(entry.data) for entry in entries) <= MAX_KEPT_BYTES:
            self._parts[part] = entries
            if len(self._parts) > 2:
                del self._parts[next(iter(self._parts))]
        return entries

    def _read(self, number: int, start_ns: int, end_ns: int) -> list[Entry]:
        """Return the messages of a time, numbered from a number."""
        try:
            return [
                Entry(
                    number + index,
                    message.log_time_ns,
                    message.log_time_ns,
                    False,
                    message.data,
                    self._decode,
                )
                for index, message in enumerate(self._bag.messages(self._topic, max(0, start_ns), end_ns))
            ]
        except BagError:
            return []  # a damaged part of the recording has no messages

    def leave(self, cursor: Cursor) -> None:
        """Do nothing: files are open while they are read only."""


@contextmanager
def recorded_viewer(path: Path, *, topics: tuple[str, str], fixed_frame: str = "") -> Iterator[Viewer]:
    """Open a viewer of a recording, or of a file of static transforms, for the block.

    Args:
        path: The recording, or a file that ends in .yaml.
        topics: The topics of moving and of static transforms.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.

    Raises:
        BagError: it is not a recording, or its transforms are on other topics.
        StaticFileError: it is not a file of static transforms.
        OSError: it can't be read.
    """
    buffer = Buffer(None)
    buffer.set_log_callback(None)
    with ExitStack() as stack:
        try:
            source = open_path(path, buffer=buffer, topics=topics)
            bag = stack.enter_context(open_bag(path))
        except BagError:
            bag = stack.enter_context(open_bag(path))
            if not bag.topics or any(topic.type in TF_TYPES for topic in bag.topics.values()):
                raise
            source = Still(observe_recorded([], str(path), buffer=buffer, topics=topics), buffer)
        if left_out := sorted(
            topic.name
            for topic in bag.topics.values()
            if topic.serialization_format != "cdr" and topic.type not in TF_TYPES
        ):
            more = " and others" if len(left_out) > MAX_NAMES else ""
            report(LEFT_OUT.format(path=path, names=", ".join(map(shown_part, left_out[:MAX_NAMES])) + more))
        viewer = stack.enter_context(Viewer(source, RecordedTopics(bag), fixed_frame=fixed_frame))
        viewer.view.recorded_span = Span(bag.start_ns, bag.end_ns)
        yield viewer
