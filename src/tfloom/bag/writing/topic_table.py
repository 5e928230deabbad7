"""The topics of a bag that is written, by the numbers of their channels."""

from __future__ import annotations

import threading
from collections.abc import Iterable

from tfloom.bag.values import Topic

__all__ = ["MAX_TOPICS", "TopicTable"]

MAX_TOPICS = 0xFFFF
"""MCAP's number of a channel has 16 bits, and is at least 1."""


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
