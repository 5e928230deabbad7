"""What writers of bags share: a file of one storage, its settings, and its topics by the numbers of their channels."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from typing import NamedTuple, Protocol

from tfloom._native import Chunk
from tfloom.bag.values import Topic

__all__ = ["MAX_TOPICS", "STORAGES", "StorageFile", "StorageSettings", "TopicTable"]

STORAGES = {"mcap": ".mcap", "sqlite3": ".db3"}
"""The storages, each with the suffix of its files."""
MAX_TOPICS = 0xFFFF
"""MCAP's number of a channel has 16 bits, and is at least 1."""


class StorageSettings(NamedTuple):
    """How a storage writes its files. Each storage uses some of these."""

    compression: str = ""
    """Compression of chunks, `lz4` or `zstd`; empty for none."""
    level: str = "Default"
    """Level of compression, Fastest, Fast, Default, Slow or Slowest."""
    chunk_size: int = 768 * 1024
    """Size of a complete chunk [bytes]."""
    is_chunked: bool = True
    """Whether messages are in chunks; compression needs them. MCAP's, as the next three."""
    has_message_index: bool = True
    """Whether each chunk is followed by an index of its messages."""
    has_summary: bool = True
    """Whether the file ends with a summary of schemas, channels and the places of chunks."""
    has_chunk_crc: bool = False
    """Whether each chunk has a checksum."""
    pragmas: tuple[str, ...] = ()
    """Of sqlite3, in addition to those of the writer."""


class StorageFile(Protocol):
    """A file that is being written."""

    @property
    def size(self) -> int:
        """Size of what is written [bytes]."""

    def write(self, chunk: Chunk) -> None:
        """Write the messages of a chunk.

        Raises:
            OSError: they can't be written; what was written before stays readable.
        """

    def close(self, metadata: str) -> None:
        """Complete the file; `metadata` is that of the bag so far, as YAML. Closing again does nothing.

        Raises:
            OSError: it can't be completed; the messages that were written stay readable.
        """


class TopicTable:
    """Topics by number, from 1. Any thread calls any method.

    A number is never given again, and what it stands for is found for as long as the bag is written, because messages
    with this number may still be waiting.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._topics: dict[int, Topic] = {}  # guarded by _lock, as the set below
        self._removed: set[int] = set()

    def __getitem__(self, number: int) -> Topic:
        with self._lock:
            return self._topics[number]

    def add(self, topic: Topic) -> int:
        """Add a topic, and return its number.

        Raises:
            ValueError: the format's limit on topics is reached.
        """
        with self._lock:
            number = len(self._topics) + 1
            if number > MAX_TOPICS:
                raise ValueError(f"a bag has at most {MAX_TOPICS} topics, removed ones included")
            self._topics[number] = topic
            return number

    def replace(self, number: int, topic: Topic) -> None:
        """Replace what is known of a topic, which is present from now on."""
        with self._lock:
            self._topics[number] = topic
            self._removed.discard(number)

    def remove(self, name: str) -> None:
        """Leave a topic out of `present`, until it is restored."""
        with self._lock:
            self._removed.update(number for number, topic in self._topics.items() if topic.name == name)

    def restore(self, numbers: Iterable[int]) -> None:
        """Let topics be present, because they have messages."""
        with self._lock:
            self._removed.difference_update(numbers)

    def present(self) -> dict[int, Topic]:
        """Return a copy of the topics that are not removed, by number."""
        with self._lock:
            return {number: topic for number, topic in self._topics.items() if number not in self._removed}
