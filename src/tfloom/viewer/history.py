"""The last messages of a topic, by their stamps, in bounded memory."""

from __future__ import annotations

import bisect
import struct
from collections.abc import Iterator, Sequence
from typing import NamedTuple, Protocol

__all__ = ["START", "Entry", "History", "Logged", "MessageLog", "Messages", "Place", "header_stamp_ns"]

MAX_BYTES = 128 * 1024 * 1024
"""Size of the messages of one topic that are kept [bytes]."""
MAX_ENTRIES = 20_000
"""Number of messages of one topic that are kept."""

Place = tuple[int, int]
"""Where a message is among those of its topic, in the order in which they came."""
START: Place = (-1, -1)
"""The place before the first message."""

_LAYOUTS = {0: struct.Struct(">iI"), 1: struct.Struct("<iI")}
"""Of a stamp's seconds and nanoseconds, by the second byte of the encapsulation header."""


class Entry(NamedTuple):
    """A message."""

    stamp_ns: int
    """Its header's stamp, or the time of its receipt where it has none [ns since epoch]."""
    data: bytes
    """Encapsulation header and CDR."""


class Logged(NamedTuple):
    """A message at its place."""

    place: Place
    from_ns: int
    """The time from which it counts [ns since epoch]."""
    entry: Entry


class MessageLog(Protocol):
    """The messages of a topic in the order in which they came."""

    is_whole: bool
    """Whether it has all messages from the first one, by their times; if not, they come while it is read."""

    def after(self, place: Place, stamp_ns: int | None) -> Iterator[Logged]:
        """Yield the messages after a place. A whole log ends at a time [ns since epoch], or for None at its end."""

    def droppable(self) -> Place:
        """Return the place up to which messages are too old to be kept."""

    def drop(self, place: Place) -> None:
        """Forget the messages up to a place."""


class Messages(Protocol):
    """The messages of one topic: those that were received, or those of a recording."""

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all."""

    def log(self) -> MessageLog:
        """Return the messages in the order in which they came, from now on those that come, too."""


class History:
    """The last messages of a topic. One thread may use it.

    Args:
        length_ns: Age, before the newest message, above which messages are dropped [ns].
        max_bytes: Size above which the oldest messages are dropped; the newest one stays [bytes].
        is_latched: Whether the publishers keep messages for late subscriptions: then the first one counts for the time
            before it, too, because it was there, only not here.
    """

    def __init__(self, length_ns: int, max_bytes: int = MAX_BYTES, *, is_latched: bool = False) -> None:
        self._is_latched = is_latched
        self._length_ns = length_ns
        self._max_bytes = max_bytes
        self._entries: list[Entry] = []
        self._numbers: list[int] = []
        """The number of each, in the order in which they came."""
        self._count = 0
        """How many have come ever."""
        self._log: _HistoryLog | None = None
        """The one that was asked for last gets those that come; None: nobody has asked."""
        self._size = 0

    def __len__(self) -> int:
        return len(self._entries)

    @property
    def size(self) -> int:
        """The size of all messages [bytes]."""
        return self._size

    def add(self, entry: Entry) -> None:
        """Add a message, and drop those that are too old or too many."""
        newest_ns = self._entries[-1].stamp_ns if self._entries else 0
        # A clock that went back, as that of a simulation or of a played recording that begins anew: what is newer
        # than now belongs to the run before.
        if entry.stamp_ns < newest_ns - self._length_ns:
            self.clear()
        place = bisect.bisect_right(self._entries, entry.stamp_ns, key=lambda other: other.stamp_ns)
        self._entries.insert(place, entry)
        self._numbers.insert(place, self._count)
        if self._log is not None:
            self._log.add(self._logged(self._count, entry))
        self._count += 1
        self._size += len(entry.data)
        oldest_ns = self._entries[-1].stamp_ns - self._length_ns
        dropped = 0
        while dropped < len(self._entries) - 1 and (
            self._entries[dropped].stamp_ns < oldest_ns
            or self._size > self._max_bytes
            or len(self._entries) - dropped > MAX_ENTRIES
        ):
            self._size -= len(self._entries[dropped].data)
            dropped += 1
        del self._entries[:dropped], self._numbers[:dropped]

    def clear(self) -> None:
        """Drop all messages."""
        self._entries.clear()
        self._numbers.clear()
        self._size = 0

    def newest(self, stamp_ns: int | None) -> Entry | None:
        """Return the last message of a stamp up to this one [ns since epoch]; None: the last of all."""
        entries = self.until(stamp_ns)
        return entries[-1] if entries else None

    def until(self, stamp_ns: int | None) -> Sequence[Entry]:
        """Return the messages with stamps up to this one, by their stamps; None: all."""
        if stamp_ns is None:
            return self._entries
        count = bisect.bisect_right(self._entries, stamp_ns, key=lambda entry: entry.stamp_ns)
        return self._entries[: max(count, int(self._is_latched))]

    def oldest_number(self) -> int:
        """Return the least number of the messages that are kept; that of the next one, if none are."""
        return min(self._numbers, default=self._count)

    def log(self) -> MessageLog:
        """Return the messages in the order in which they came, from those that are kept now."""
        self._log = _HistoryLog(self)
        for number, entry in sorted(zip(self._numbers, self._entries, strict=True)):
            self._log.add(self._logged(number, entry))
        return self._log

    def _logged(self, number: int, entry: Entry) -> Logged:
        return Logged((number, 0), 0 if self._is_latched and not number else entry.stamp_ns, entry)


class _HistoryLog:
    """The messages of a history in the order in which they came; also those that it has dropped."""

    is_whole = False

    def __init__(self, history: History) -> None:
        self._history = history
        self._messages: list[Logged] = []

    def add(self, logged: Logged) -> None:
        self._messages.append(logged)

    def after(self, place: Place, stamp_ns: int | None) -> Iterator[Logged]:  # stamps are in no order
        return iter(self._messages[self._index_after(place) :])

    def droppable(self) -> Place:
        return self._history.oldest_number() - 1, 0

    def drop(self, place: Place) -> None:
        del self._messages[: self._index_after(place)]

    def _index_after(self, place: Place) -> int:
        return bisect.bisect_right(self._messages, place, key=lambda logged: logged.place)


def header_stamp_ns(data: bytes) -> int:
    """Return the stamp with which a message begins [ns since epoch]; 0 where the bytes have none."""
    layout = _LAYOUTS.get(data[1]) if len(data) >= 12 else None
    if layout is None:
        return 0
    sec, nanosec = layout.unpack_from(data, 4)
    return int(sec) * 1_000_000_000 + int(nanosec)
