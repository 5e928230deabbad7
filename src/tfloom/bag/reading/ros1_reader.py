"""Messages and transforms of a bag of ROS 1. The one place that imports rosbags."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any

from tfloom._native import TfRecords
from tfloom.bag.errors import BagError
from tfloom.bag.reading.message_transforms import insert_messages
from tfloom.bag.reading.ros1_scan import MAGIC, Ros1Scan, has_index
from tfloom.bag.reading.ros1_source import opened
from tfloom.bag.values import Definition, Progress, RawMessage, TfTopic, Topic

__all__ = ["Ros1File"]


class Ros1File:
    """A bag of ROS 1, whose messages are serialized in its own way. It is open while it is read only.

    A bag without an index is read by its records, which needs no library.

    Args:
        path: The file.

    Raises:
        BagError: it is no bag of ROS 1, or damaged, or the library rosbags isn't installed.
        OSError: it can't be read.
    """

    is_message_compressed = False

    def __init__(self, path: Path) -> None:
        self.path = path
        with path.open("rb") as file:
            start = file.read(len(MAGIC))
        if not start:
            raise BagError(path, "the file is empty: its recorder ended before it wrote anything")
        if start != MAGIC:
            raise BagError(path, f"this is no bag of ROS 1, version 2.0: it begins with {start!r}", 0)
        self._scan = None if has_index(path) else Ros1Scan(path)
        if self._scan is not None:
            self._topics = self._scan.topics
            self.message_count = self._scan.message_count
            self.start_ns, self.end_ns = self._scan.start_ns, self._scan.end_ns
            return
        with self._open() as reader:
            self._topics = {name: _topic(name, about) for name, about in reader.topics.items()}
            self.message_count = int(reader.message_count)
            self.start_ns = reader.start_time if self.message_count else 0
            self.end_ns = reader.end_time - 1 if self.message_count else 0

    @cached_property
    def topics(self) -> list[Topic]:
        """The topics, one for each name."""
        return list(self._topics.values())

    @contextmanager
    def _open(self) -> Iterator[Any]:
        """Open the bag for the block; raise BagError for what the library raises."""
        try:
            from rosbags.rosbag1 import Reader, ReaderError
        except ImportError:
            raise BagError(
                self.path, "rosbags is needed for a bag of ROS 1: install it by `pip install 'tfloom[bag]'`"
            ) from None
        try:
            with opened(Reader(self.path), self.path) as reader:
                yield reader
        except BagError:
            raise
        except ReaderError as error:
            raise BagError(self.path, f"the bag can't be read: {error}") from None
        except (ValueError, LookupError, TypeError, AssertionError, RuntimeError, EOFError) as error:
            raise BagError(self.path, f"the bag is damaged: {error or type(error).__name__}") from None

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: the file is damaged.
        """
        if self._scan is not None:
            yield from self._scan.messages(topics, start_ns, end_ns)
            return
        with self._open() as reader:
            wanted = [each for each in reader.connections if topics is None or each.topic in topics]
            if wanted:
                for connection, stamp, data in reader.messages(wanted, start_ns, end_ns + 1):
                    yield RawMessage(connection.topic, stamp, stamp, bytes(data))

    def insert_transforms(
        self,
        into: TfRecords,
        topics: Mapping[str, TfTopic],
        start_ns: int,
        end_ns: int,
        progress: Progress,
    ) -> None:
        """Store the transforms of topics by name; moving ones if their log times are in [start, end].

        Raises:
            BagError: the file is damaged.
        """
        insert_messages(self.messages, into, topics, (start_ns, end_ns), progress)


def _topic(name: str, about: Any) -> Topic:
    connection = about.connections[0]
    definition = connection.msgdef.data if connection.msgdef else ""
    return Topic(
        name,
        about.msgtype or connection.msgtype,
        "ros1",
        definition=Definition("ros1msg", definition) if definition else None,
        message_count=about.msgcount,
    )
