"""The last messages of topics with which further files of a bag, and snapshots, begin."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable

from tfloom._native import Chunk, ChunkQueue

__all__ = ["UNLIMITED", "RepeatedMessages", "chunk_of", "later_part"]

UNLIMITED = 1 << 62
Found = tuple[int, int, int, bytes]
"""A message: channel, log time, publish time [ns since epoch], bytes."""


def chunk_of(messages: Iterable[Found]) -> Chunk | None:
    """Return messages as one chunk; None if there are none."""
    queue = ChunkQueue(UNLIMITED, UNLIMITED)
    for channel, log_ns, publish_ns, data in messages:
        queue.push(channel, data, log_ns, publish_ns)
    return queue.take(0)


def later_part(chunk: Chunk, start_ns: int) -> Chunk | None:
    """Return the messages of a chunk from a log time on [ns since epoch]; None if there are none."""
    if chunk.start_ns >= start_ns:
        return chunk
    return chunk_of(message for message in chunk.messages() if message[1] >= start_ns)


class RepeatedMessages:
    """The last messages of some channels. One thread at a time calls its methods, but for `add`."""

    def __init__(self) -> None:
        self._last: dict[int, deque[Found]] = {}

    def __contains__(self, channel: int) -> bool:
        return channel in self._last

    def add(self, channel: int, depth: int) -> None:
        """Keep the last messages of a channel, so many of them."""
        self._last.setdefault(channel, deque(maxlen=depth))

    def note(self, chunk: Chunk) -> None:
        """Keep what is to be kept of a chunk that is written."""
        # Messages become Python objects only where a chunk has a channel that is kept, which few chunks have.
        if self._last and any(channel in self._last for channel, _ in chunk.counts()):
            self.note_messages(chunk.messages())

    def note_messages(self, messages: Iterable[Found]) -> None:
        """Keep what is to be kept of messages, which are in the order of their log times in each channel."""
        for message in messages:
            if message[0] in self._last:
                self._last[message[0]].append(message)

    def chunk_at(self, stamp_ns: int) -> Chunk | None:
        """Return what is kept, with another log time [ns since epoch]; None if nothing is kept.

        With its own one, a file that begins with what was received an hour ago would be an hour longer.
        """
        kept = sorted((message for last in list(self._last.values()) for message in last), key=_log_time)
        return chunk_of((channel, stamp_ns, publish_ns, data) for channel, _, publish_ns, data in kept)


def _log_time(message: Found) -> int:
    return message[1]
