"""The messages of one topic in the order in which they came, in bounded memory; and the places of its readers there.

What a log drops, oldest arrival first:

- from its history, which `newest` searches by stamps: a message of which the next one is older than the log's length
  (so that the one that counts at the start of the history is there), and what is above a size or a number. The newest
  message stays. When a clock goes back by more than the length, as that of a simulation or of a played recording that
  begins anew, the history begins anew, because what is newer than now belongs to the run before.
- from memory: what has left the history, once each reader has passed it; above twice the size or the number, also what
  a reader has not.
"""

from __future__ import annotations

import bisect
import math
import struct
import time
from collections.abc import Callable, Iterator
from itertools import count
from typing import Any, NamedTuple, Protocol

__all__ = ["END", "RUN_NS", "START", "Cursor", "Entry", "Log", "TopicLog", "header_stamp_ns"]

MAX_BYTES = 128 * 1024 * 1024
"""Size of the messages of one topic in its history [bytes]."""
MAX_ENTRIES = 20_000
"""Number of messages of one topic in its history."""
RUN_NS = 60_000_000_000
"""How far before a message those are that are shown with it, where nothing else is said [ns]."""
START = -1
"""The place before the first message."""
END = 2**63
"""The place behind all messages: of a reader for which none is kept beyond the history."""

_LAYOUTS = {0: struct.Struct(">iI"), 1: struct.Struct("<iI")}
"""Of a stamp's seconds and nanoseconds, by the second byte of the encapsulation header."""


class Entry(NamedTuple):
    """A message."""

    number: int
    """Its place among those of its topic, in the order in which they came."""
    stamp_ns: int
    """Its header's stamp, or the time of its receipt where it has none [ns since epoch]."""
    from_ns: int
    """The time from which it counts: the stamp; 0 for the first one of publishers that keep messages for late
    subscriptions, because it was there before, only not here [ns since epoch]."""
    begins_anew: bool
    """Whether the clock has gone back, and what came before belongs to another run."""
    data: bytes
    """Encapsulation header and CDR."""
    decode: Callable[[bytes], Any]

    def message(self) -> Any:
        """Return the message.

        Raises:
            DecodeError: the bytes are none.
        """
        return self.decode(self.data)


class Log(Protocol):
    """The messages of a topic: those that were received, or those of a recording."""

    is_whole: bool
    """Whether it has all messages from the first one, by their times; if not, they come while it is read."""

    @property
    def first(self) -> int:
        """The number of the first message of the history."""

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all."""

    def run(self, entry: Entry, count: int, length_ns: int = RUN_NS) -> list[Entry]:
        """Return up to so many messages of a length of time that end with this one, in the order of their stamps."""

    def parts(self, number: int, until_ns: int | None) -> Iterator[tuple[int, list[Entry]]]:
        """Yield the messages behind a place, in parts, each with the place behind it.

        Those of a whole log end at a time [ns since epoch], or for None at its end.
        """

    def leave(self, cursor: Cursor) -> None:
        """Keep nothing more for a reader."""


class Cursor:
    """The place of one reader in a log.

    Args:
        log: The log.
        number: The place: that of the last message that the reader has.
        depth: Number of messages of the topic that may wait to be taken; 0: as is usual for it.
    """

    def __init__(self, log: Log, number: int = START, depth: int = 0) -> None:
        self.log = log
        self.number = number
        self.depth = depth
        self.is_behind = False
        """Whether `read` has left messages for the next time."""

    def read(self, until_ns: int | None = None, limit_s: float = math.inf) -> Iterator[Entry]:
        """Yield the messages behind the place, which moves on.

        Args:
            until_ns: The time at which those of a recording end [ns since epoch]; None: at its end.
            limit_s: How long they are read [s]; one message, or one part without any, is in any case.
        """
        first, end_s = self.number, time.monotonic() + limit_s
        self.is_behind = True
        for number, entries in self.log.parts(self.number, until_ns):
            for entry in entries:
                if self.number > first and time.monotonic() > end_s:
                    return
                self.number = entry.number
                yield entry
            if not entries and self.number > first and time.monotonic() > end_s:
                return
            self.number = number
        self.is_behind = False

    def close(self) -> None:
        """End reading."""
        self.log.leave(self)


class TopicLog:
    """The last messages of a topic. One thread may use it.

    Args:
        length_ns: The length of the history, before the newest message [ns].
        decode: Returns the message of an entry's bytes.
        is_latched: Whether the publishers keep messages for late subscriptions.
        max_bytes: Size of the history [bytes].
        numbers: Numbers for the messages that come.
        on_left: Called when the last reader has left.
    """

    is_whole = False

    def __init__(
        self,
        length_ns: int,
        decode: Callable[[bytes], Any],
        *,
        is_latched: bool = False,
        max_bytes: int = MAX_BYTES,
        numbers: Iterator[int] | None = None,
        on_left: Callable[[], None] = lambda: None,
    ) -> None:
        self._length_ns = length_ns
        self._decode = decode
        self.is_latched = is_latched
        """Whether its publishers keep messages for late subscriptions."""
        self._max_bytes = max_bytes
        self._numbers = count() if numbers is None else numbers
        self._on_left = on_left
        self._cursors: list[Cursor] = []
        self._is_empty = True
        """Whether no message has come ever."""
        self._entries: list[Entry] = []
        """In the order in which they came; `_start` is the index of the first one of the history."""
        self._start = 0
        self._by_stamp: list[Entry] = []
        """The history, in the order of its stamps."""
        self._sizes = [0, 0]
        """Size of all messages, and of those of the history [bytes]."""

    def __len__(self) -> int:
        return len(self._by_stamp)

    @property
    def depths(self) -> list[int]:
        """The depth that each of its readers asks for."""
        return [cursor.depth for cursor in self._cursors]

    @property
    def size(self) -> int:
        """The size of the history [bytes]."""
        return self._sizes[1]

    @property
    def first(self) -> int:
        """The number of the first message of the history; 0 where there is none."""
        return self._entries[self._start].number if self._by_stamp else 0

    def add(self, stamp_ns: int, data: bytes) -> None:
        """Add a message, and drop those that are too old or too many."""
        begins_anew = bool(self._by_stamp) and stamp_ns < self._by_stamp[-1].stamp_ns - self._length_ns
        if begins_anew:
            self._start, self._sizes[1] = len(self._entries), 0
            self._by_stamp.clear()
        from_ns = 0 if self.is_latched and self._is_empty else stamp_ns
        self._is_empty = False
        entry = Entry(next(self._numbers), stamp_ns, from_ns, begins_anew, data, self._decode)
        self._entries.append(entry)
        bisect.insort(self._by_stamp, entry, key=_order)
        self._sizes = [size + len(data) for size in self._sizes]
        self._drop()

    def _drop(self) -> None:
        oldest_ns = self._by_stamp[-1].stamp_ns - self._length_ns
        while len(self._by_stamp) > 1 and (
            self._entries[self._start + 1].stamp_ns <= oldest_ns or self._is_above(1, len(self._by_stamp))
        ):
            entry = self._entries[self._start]
            self._start += 1
            del self._by_stamp[bisect.bisect_left(self._by_stamp, _order(entry), key=_order)]
            self._sizes[1] -= len(entry.data)
        passed = min((cursor.number for cursor in self._cursors), default=math.inf)
        dropped = 0
        while dropped < self._start and (
            self._entries[dropped].number <= passed or self._is_above(0, len(self._entries) - dropped)
        ):
            self._sizes[0] -= len(self._entries[dropped].data)
            dropped += 1
        del self._entries[:dropped]
        self._start -= dropped

    def _is_above(self, part: int, number: int) -> bool:
        """Return whether there are too many messages, or too large ones, in memory (0) or in the history (1)."""
        factor = 2 - part
        return number > factor * MAX_ENTRIES or self._sizes[part] > factor * self._max_bytes

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all.

        Before the first one of publishers that keep messages for late subscriptions, that one counts.
        """
        history = self._by_stamp
        index = len(history)
        if stamp_ns is not None:
            index = bisect.bisect_right(history, stamp_ns, key=lambda entry: entry.stamp_ns)
        index = max(index, int(self.is_latched and bool(history)))
        return history[index - 1] if index else None

    def run(self, entry: Entry, count: int, length_ns: int = RUN_NS) -> list[Entry]:
        """Return up to so many messages of a length of time that end with this one, in the order of their stamps."""
        end = bisect.bisect_left(self._by_stamp, _order(entry), key=_order)
        before = self._by_stamp[max(0, end + 1 - count) : end]
        return [*(one for one in before if one.stamp_ns >= entry.stamp_ns - length_ns), entry]

    def parts(
        self,
        number: int,
        until_ns: int | None,  # stamps are in no order
    ) -> Iterator[tuple[int, list[Entry]]]:
        """Yield the messages behind a place, whatever their stamps."""
        index = bisect.bisect_right(self._entries, number, key=lambda entry: entry.number)
        if entries := self._entries[index:]:
            yield entries[-1].number, entries

    def open(self, depth: int = 0) -> Cursor:
        """Return a new reader, for which messages are kept until its place is behind them."""
        self._cursors.append(cursor := Cursor(self, depth=depth))
        return cursor

    def leave(self, cursor: Cursor) -> None:
        """Keep nothing more for a reader; leaving twice is leaving once."""
        if cursor in self._cursors:
            self._cursors.remove(cursor)
            if not self._cursors:
                self._on_left()


def _order(entry: Entry) -> tuple[int, int]:
    return entry.stamp_ns, entry.number


def header_stamp_ns(data: bytes) -> int:
    """Return the stamp with which a message begins [ns since epoch]; 0 where the bytes have none."""
    layout = _LAYOUTS.get(data[1]) if len(data) >= 12 else None
    if layout is None:
        return 0
    sec, nanosec = layout.unpack_from(data, 4)
    return int(sec) * 1_000_000_000 + int(nanosec)
