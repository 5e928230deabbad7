"""Where the messages of a ROS 1 bag are, and the messages of its chunks."""

from __future__ import annotations

import io
import warnings
from collections import Counter
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import NamedTuple

from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.reading.compression import CompressionError, DamagedError, decompress
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.message_order import Found, in_order
from tfloom.bag.reading.ros1_implausible import check_plausible
from tfloom.bag.reading.ros1_records import (
    CONNECTION,
    MESSAGE,
    DamagedRecordError,
    Record,
    read_fields,
    records,
)
from tfloom.bag.values import Definition, RawMessage, Topic

__all__ = ["Ros1Layout", "Span"]


class Connection(NamedTuple):
    topic: str
    type: str
    definition: str


class Span(NamedTuple):
    """A chunk, or records that are in none."""

    start_ns: int
    end_ns: int
    offset: int
    stored_size: int
    compression: str
    size: int
    """Decompressed [bytes]."""
    connections: frozenset[int]
    indexed_count: int | None = None
    """How many messages its index has; None if times and connections are those of its records."""


class Ros1Layout:
    """What a bag holds.

    Args:
        path: The bag.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.spans: list[Span] = []
        self.counts: Counter[int] = Counter()
        """Messages of each connection."""
        self._connections: dict[int, Connection] = {}

    @property
    def start_ns(self) -> int:
        """The least log time [ns since epoch]; 0 without messages."""
        return min((span.start_ns for span in self.spans), default=0)

    @property
    def end_ns(self) -> int:
        """The greatest log time [ns since epoch]; 0 without messages."""
        return max((span.end_ns for span in self.spans), default=0)

    @property
    def message_count(self) -> int:
        """Number of messages of the connections that are described."""
        return sum(self.counts[number] for number in self._connections)

    def describes(self, connections: Collection[int]) -> bool:
        """Return whether topic and type of all these connections are known."""
        return self._connections.keys() >= set(connections)

    @property
    def topics(self) -> dict[str, Topic]:
        """The topics by name; each with the type of its first connection."""
        # Each publisher of a topic has its own connection.
        topics: dict[str, Topic] = {}
        for number, connection in self._connections.items():
            text = connection.definition
            definition = Definition("ros1msg", text) if text else None
            topic = topics.get(
                connection.topic, Topic(connection.topic, connection.type, "ros1", definition=definition)
            )
            count = topic.message_count + self.counts[number]
            topics[connection.topic] = topic._replace(message_count=count)
        return topics

    def warn_of_unknown_connections(self) -> None:
        """Warn of the messages that are left out, because no record says their topic and type."""
        self._warn_of_unknown(self.counts.total() - self.message_count)

    def _warn_of_unknown(self, count: int) -> None:
        if count:
            text = (
                f"{self.path}: {count} messages are left out, because no record describes their connections"
            )
            warnings.warn(BagWarning(text), stacklevel=3)

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: a chunk can't be decompressed.
        """
        names = {
            number: connection.topic
            for number, connection in self._connections.items()
            if topics is None or connection.topic in topics
        }
        spans = [
            span
            for span in self.spans
            if span.start_ns <= end_ns and span.end_ns >= start_ns and not span.connections.isdisjoint(names)
        ]
        spans.sort(key=lambda span: span.start_ns)
        with io.FileIO(self.path) as file:
            for stamp, number, _, data in in_order(
                spans, lambda span: self._messages(file, span, names, (start_ns, end_ns))
            ):
                yield RawMessage(names[number], stamp, stamp, data)

    def _messages(
        self, file: io.FileIO, span: Span, connections: Collection[int], times: tuple[int, int]
    ) -> list[Found]:
        data = self.decompressed(file, span.offset, span.stored_size, span.compression, span.size)
        messages: list[Found] = []
        count = outside = unknown = 0
        # All messages are counted, also those that aren't asked for: an index that names other numbers or times than
        # the chunk has would leave messages out in silence, and only this walk can tell.
        try:
            for record in records(data, 0):
                if record.kind != MESSAGE:
                    continue
                count += 1
                stamp = record.stamp_ns()
                outside += not span.start_ns <= stamp <= span.end_ns
                number = record.number("conn", 4)
                unknown += number not in self._connections
                if number in connections and times[0] <= stamp <= times[1]:
                    messages.append((stamp, number, stamp, data[record.begin : record.end]))
        except DamagedRecordError as error:
            if span.indexed_count is not None:  # else the walk has warned of it
                self.warn_of_damage(span.offset, str(error))
        if span.indexed_count is not None:
            if count != span.indexed_count:
                reason = f"its index has {span.indexed_count} messages, and {count} are there"
                self.warn_of_damage(span.offset, reason, "these are read")
            self._warn_of_unknown(unknown)
        if outside:
            reason = f"{outside} of its messages have log times outside those of its index"
            self.warn_of_damage(span.offset, reason, "a part of the bag, chosen by times, may lack them")
        return messages

    def add_chunk(self, file: io.FileIO, record: Record) -> None:
        """Add a chunk by its content.

        Raises:
            BagError: it can't be decompressed, because the compression is unknown, or its library isn't installed.
            DamagedRecordError: its header is damaged.
        """
        compression = compression_of(record)
        size = record.number("size", 4)
        data = self.decompressed(file, record.begin, record.size, compression, size)
        try:
            end = self.add(data, 0, record.begin, record.size, compression)
        except DamagedRecordError as error:
            self.warn_of_damage(record.begin, str(error))
        else:
            if end != len(data):
                self.warn_of_damage(record.begin, f"it has no whole record at byte {end}")

    def add(
        self, data: bytes, begin: int, offset: int, stored_size: int = 0, compression: str = "none"
    ) -> int:
        """Add connections and messages from `begin` on; return where the first other record begins.

        Args:
            data: Records.
            begin: Where the first one begins.
            offset: Of the records in the file, compressed if they are.
            stored_size: Of a chunk in the file [bytes]; 0: the records' own.
            compression: Of a chunk.

        Raises:
            DamagedRecordError: a record is damaged; those before are added.
        """
        counts: Counter[int] = Counter()
        times = []
        end = begin
        try:
            for record in records(data, begin):
                if record.kind == MESSAGE:
                    times.append(record.stamp_ns())
                    counts[record.number("conn", 4)] += 1
                elif record.kind == CONNECTION:
                    self.add_connection(record, data[record.begin : record.end])
                else:
                    break
                end = record.end
        finally:
            # Also if a record is damaged: the messages before it are kept. `end` is where the last whole one ends.
            if times:
                self.counts += counts
                sizes = (stored_size or end - begin, compression, len(data) if stored_size else end - begin)
                self.spans.append(Span(min(times), max(times), offset, *sizes, frozenset(counts)))
        return end

    def add_connection(self, record: Record, data: bytes) -> None:
        """Add topic and type of a connection, unless they are known.

        Raises:
            DamagedRecordError: a field is damaged.
        """
        fields = {name: value.decode("utf-8", "replace") for name, value in read_fields(data).items()}
        package, _, name = fields.get("type", "").partition("/")
        topic = record.fields.get("topic", b"").decode("utf-8", "replace")
        self._connections.setdefault(
            record.number("conn", 4),
            Connection(topic, f"{package}/msg/{name}", fields.get("message_definition", "")),
        )

    def decompressed(
        self, file: io.FileIO, offset: int, stored_size: int, compression: str, size: int
    ) -> bytes:
        """Return the records of a chunk; none, after a warning, if they are damaged."""
        if compression not in {"none", "bz2", "lz4"}:
            reason = f"the compression is '{compression[:40]}', which is none of bz2 and lz4"
            raise BagError(self.path, reason, offset)
        data = read_at(file, offset, stored_size)
        try:
            if compression == "none":
                return decompress("", data, size)
            check_plausible(compression, data, size)
            return decompress(compression, data, size)
        except DamagedError as error:
            self.warn_of_damage(offset, str(error))
            return b""
        except CompressionError as error:
            raise BagError(self.path, str(error), offset) from None

    def warn_of_damage(self, offset: int, reason: str, then: str = "it is read up to there") -> None:
        """Warn that a chunk is damaged."""
        text = f"{self.path}: byte {offset}: a chunk of messages is damaged: {reason}; {then}"
        warnings.warn(BagWarning(text), stacklevel=2)


def compression_of(record: Record) -> str:
    """Return the compression of a chunk."""
    return record.fields.get("compression", b"").decode("ascii", "replace")
