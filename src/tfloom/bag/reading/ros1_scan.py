"""The messages of a ROS 1 bag without an index: a walk over its records, up to the last whole one.

http://wiki.ros.org/Bags/Format/2.0
"""

from __future__ import annotations

import io
import struct
import warnings
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.reading.compression import MOST, CompressionError, DamagedError, decompress
from tfloom.bag.reading.file_bytes import BLOCK, read_at
from tfloom.bag.reading.message_order import Found, in_order
from tfloom.bag.values import Definition, RawMessage, Topic

__all__ = ["Ros1Scan", "has_index"]

MAGIC = b"#ROSBAG V2.0\n"
MESSAGE, BAG_HEADER, INDEX, CHUNK, CHUNK_INFO, CONNECTION = 2, 3, 4, 5, 6, 7
_NUMBERS = {1: struct.Struct("<B"), 4: struct.Struct("<I"), 8: struct.Struct("<Q")}
_LENGTH = _NUMBERS[4]
_STAMP = struct.Struct("<II")
MOST_HEADER = 1 << 20
"""The greatest size of a record's header that is read [bytes]."""


class _DamagedRecordError(ValueError):
    """A record is not as its kind requires; the text has the reason."""


class _Record(NamedTuple):
    """A record, in bytes or in a file."""

    fields: Mapping[str, bytes]
    begin: int
    """Offset of its data."""
    size: int
    """Of its data [bytes]."""

    @property
    def kind(self) -> int:
        return self.number("op", 1)

    @property
    def end(self) -> int:
        return self.begin + self.size

    def number(self, name: str, size: int) -> int:
        """Return a field with an integer of `size` bytes."""
        value = self.fields.get(name, b"")
        if len(value) != size:
            raise _DamagedRecordError(f"the field '{name}' of a record has {len(value)} bytes, not {size}")
        (number,) = _NUMBERS[size].unpack(value)
        return int(number)

    def stamp_ns(self) -> int:
        """Return the field `time` [ns since epoch]."""
        _ = self.number("time", 8)
        seconds, rest = _STAMP.unpack(self.fields["time"])
        return int(seconds) * 1_000_000_000 + int(rest)


class _Connection(NamedTuple):
    topic: str
    type: str
    definition: str


class _Span(NamedTuple):
    """A chunk, or records that are in none."""

    start_ns: int
    end_ns: int
    offset: int
    stored_size: int
    compression: str
    size: int
    """Decompressed [bytes]."""
    connections: frozenset[int]


def has_index(path: Path) -> bool:
    """Return whether the header of a bag names an index within the file; True if the header can't be read.

    Raises:
        OSError: the file can't be read.
    """
    with io.FileIO(path) as file:
        try:
            record = _record_at(file, len(MAGIC))
            place = record.number("index_pos", 8) if record and record.kind == BAG_HEADER else 1
        except _DamagedRecordError:
            return True
        return 0 < place < file.seek(0, io.SEEK_END)


class Ros1Scan:
    """What a bag holds whose index is missing.

    Args:
        path: The bag.

    Raises:
        BagError: a chunk can't be decompressed, because the compression is unknown, or its library isn't installed.
        OSError: the file can't be read.

    Attributes:
        start_ns: The least log time [ns since epoch]; 0 without messages.
        end_ns: The greatest one [ns since epoch].
        message_count: Number of messages.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._connections: dict[int, _Connection] = {}
        self._counts: Counter[int] = Counter()
        self._spans: list[_Span] = []
        self._block = b""
        self._block_at = 0
        with io.FileIO(path) as file:
            self._walk(file)
        self.start_ns = min((each.start_ns for each in self._spans), default=0)
        self.end_ns = max((each.end_ns for each in self._spans), default=0)
        self.message_count = self._counts.total()
        self._block = b""

    @property
    def topics(self) -> dict[str, Topic]:
        """The topics by name; each with the type of its first connection."""
        found: dict[str, Topic] = {}
        for number, each in self._connections.items():
            definition = Definition("ros1msg", each.definition) if each.definition else None
            topic = found.get(each.topic, Topic(each.topic, each.type, "ros1", definition=definition))
            found[each.topic] = topic._replace(message_count=topic.message_count + self._counts[number])
        return found

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: a chunk can't be decompressed.
        """
        names = {
            number: each.topic
            for number, each in self._connections.items()
            if topics is None or each.topic in topics
        }
        spans = [
            each
            for each in self._spans
            if each.start_ns <= end_ns and each.end_ns >= start_ns and not each.connections.isdisjoint(names)
        ]
        spans.sort(key=lambda each: each.start_ns)
        with io.FileIO(self._path) as file:
            for stamp, number, _, data in in_order(spans, lambda span: self._messages(file, span)):
                if number in names and start_ns <= stamp <= end_ns:
                    yield RawMessage(names[number], stamp, stamp, data)

    def _messages(self, file: io.FileIO, span: _Span) -> list[Found]:
        data = self._decompressed(file, span.offset, span.stored_size, span.compression, span.size)
        found: list[Found] = []
        try:
            for record in _records(data, 0):
                if record.kind == MESSAGE:
                    stamp = record.stamp_ns()
                    found.append((stamp, record.number("conn", 4), stamp, data[record.begin : record.end]))
        except _DamagedRecordError:
            pass  # the walk has warned of it
        return found

    def _walk(self, file: io.FileIO) -> None:
        """Find the connections, and what has messages."""
        at = len(MAGIC)
        reason = ""
        try:
            while (record := _record_at(file, at)) is not None:
                following = self._read(file, at, record)
                if following is None:
                    break
                at = following
        except _DamagedRecordError as error:
            reason = f", and is read up to byte {at}, because what follows is damaged: {error}"
        text = (
            f"{self._path}: the file has no index, because it is still being recorded or its recorder was killed"
            f"{reason}; {self._counts.total()} messages are read, to the last whole one"
        )
        warnings.warn(BagWarning(text), stacklevel=2)

    def _read(self, file: io.FileIO, at: int, record: _Record) -> int | None:
        """Read the record at an offset; return that of the next one, or None if the file ends in it."""
        if record.kind in {MESSAGE, CONNECTION}:
            return self._read_loose(file, at, record)
        size = file.seek(0, io.SEEK_END)
        if record.kind == CHUNK:
            compression = record.fields.get("compression", b"").decode("ascii", "replace")
            if record.size and record.end <= size:
                self._read_chunk(file, record, compression)
            elif compression == "none":
                return record.begin  # its size isn't written yet, or it is cut off: its records follow
            else:
                return None
        elif record.kind not in {BAG_HEADER, INDEX, CHUNK_INFO}:
            raise _DamagedRecordError(f"a record of kind {record.kind} is there")
        return record.end

    def _read_chunk(self, file: io.FileIO, record: _Record, compression: str) -> None:
        size = record.number("size", 4)
        data = self._decompressed(file, record.begin, record.size, compression, size)
        try:
            end = self._add(data, 0, record.begin, record.size, compression)
        except _DamagedRecordError as error:
            self._warn_of_damage(record.begin, str(error))
        else:
            if end != len(data):
                self._warn_of_damage(record.begin, f"it has no whole record at byte {end}")

    def _read_loose(self, file: io.FileIO, at: int, record: _Record) -> int | None:
        """Read records that aren't in a chunk, of one block; return the offset after them."""
        size = record.end - at
        if record.end > file.seek(0, io.SEEK_END):
            return None
        if size > MOST:
            raise _DamagedRecordError(f"{size} bytes are declared, more than the {MOST} that are accepted")
        if record.end > self._block_at + len(self._block):
            self._block, self._block_at = read_at(file, at, max(BLOCK, size)), at
        begin = at - self._block_at
        end = self._add(self._block, begin, at)
        return None if end == begin else self._block_at + end

    def _add(
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
            _DamagedRecordError: a record is damaged; those before are added.
        """
        counts: Counter[int] = Counter()
        times = []
        end = begin
        try:
            for record in _records(data, begin):
                if record.kind == MESSAGE:
                    times.append(record.stamp_ns())
                    counts[record.number("conn", 4)] += 1
                elif record.kind == CONNECTION:
                    self._add_connection(record, data[record.begin : record.end])
                else:
                    break
                end = record.end
        finally:
            if times:
                self._counts += counts
                sizes = (stored_size or end - begin, compression, len(data) if stored_size else end - begin)
                self._spans.append(_Span(min(times), max(times), offset, *sizes, frozenset(counts)))
        return end

    def _add_connection(self, record: _Record, data: bytes) -> None:
        fields = {name: value.decode("utf-8", "replace") for name, value in _fields(data).items()}
        package, _, name = fields.get("type", "").partition("/")
        topic = record.fields.get("topic", b"").decode("utf-8", "replace")
        self._connections.setdefault(
            record.number("conn", 4),
            _Connection(topic, f"{package}/msg/{name}", fields.get("message_definition", "")),
        )

    def _decompressed(
        self, file: io.FileIO, offset: int, stored_size: int, compression: str, size: int
    ) -> bytes:
        """Return the records of a chunk; none, after a warning, if they are damaged."""
        if compression not in {"none", "bz2", "lz4"}:
            reason = f"the compression is '{compression[:40]}', which is none of bz2 and lz4"
            raise BagError(self._path, reason, offset)
        data = read_at(file, offset, stored_size)
        try:
            if compression == "bz2":
                return _without_bz2(data, size)
            return decompress("" if compression == "none" else compression, data, size)
        except DamagedError as error:
            self._warn_of_damage(offset, str(error))
            return b""
        except CompressionError as error:
            raise BagError(self._path, str(error), offset) from None

    def _warn_of_damage(self, offset: int, reason: str) -> None:
        text = (
            f"{self._path}: byte {offset}: a chunk of messages is damaged: {reason}; it is read up to there"
        )
        warnings.warn(BagWarning(text), stacklevel=2)


def _record_at(file: io.FileIO, at: int) -> _Record | None:
    """Return the record at an offset in a file; None if the file ends in its header."""
    start = read_at(file, at, BLOCK >> 10)
    if len(start) < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack_from(start)
    if length > MOST_HEADER:
        raise _DamagedRecordError(f"a record's header has {length} bytes")
    if len(start) < length + 2 * _LENGTH.size:
        start = read_at(file, at, length + 2 * _LENGTH.size)
    record = _record(start, 0)
    return None if record is None else record._replace(begin=at + record.begin)


def _record(data: bytes, at: int) -> _Record | None:
    """Return the record at an offset in bytes, which may lack its data; None if they end in its header."""
    if len(data) - at < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack_from(data, at)
    begin = at + _LENGTH.size + length + _LENGTH.size
    if begin > len(data):
        return None
    header = data[at + _LENGTH.size : begin - _LENGTH.size]
    return _Record(_fields(header), begin, *_LENGTH.unpack_from(data, begin - _LENGTH.size))


def _records(data: bytes, at: int) -> Iterator[_Record]:
    """Yield the whole records in bytes."""
    while (record := _record(data, at)) is not None and record.end <= len(data):
        yield record
        at = record.end


def _fields(header: bytes) -> dict[str, bytes]:
    """Return the fields of a header: each is its length, its name, `=` and its value."""
    found = {}
    at = 0
    while at < len(header):
        begin = at + _LENGTH.size
        if begin > len(header):
            raise _DamagedRecordError("a header ends in the length of a field")
        (length,) = _LENGTH.unpack_from(header, at)
        at = begin + length
        name, sign, value = header[begin:at].partition(b"=")
        if at > len(header) or not sign:
            raise _DamagedRecordError(f"a field of {length} bytes is none")
        found[name.decode("ascii", "replace")] = value
    return found


def _without_bz2(data: bytes, size: int) -> bytes:
    try:
        import bz2
    except ImportError:
        raise CompressionError("this Python has no module bz2") from None
    if size > MOST:
        raise DamagedError(f"{size} bytes are declared, more than the {MOST} that are accepted")
    try:
        found = bz2.BZ2Decompressor().decompress(data, size) if size else b""
    except (OSError, EOFError, ValueError) as error:
        raise DamagedError(f"the bz2 data is damaged: {error}") from None
    if len(found) != size:
        raise DamagedError(f"{size} bytes are declared, and {len(found)} are there")
    return found
