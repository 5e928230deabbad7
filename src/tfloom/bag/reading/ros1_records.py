"""The records of ROS 1 bags: a header of named fields, then data. Each length is checked against the bytes left.

http://wiki.ros.org/Bags/Format/2.0
"""

from __future__ import annotations

import io
import struct
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from tfloom.bag.reading.file_bytes import BLOCK, read_at

__all__ = ["MAGIC", "DamagedRecordError", "Record", "read_fields", "record_at", "records", "records_of_file"]

MAGIC = b"#ROSBAG V2.0\n"
MESSAGE, BAG_HEADER, INDEX, CHUNK, CHUNK_INFO, CONNECTION = 2, 3, 4, 5, 6, 7
_NUMBERS = {1: struct.Struct("<B"), 4: struct.Struct("<I"), 8: struct.Struct("<Q")}
_LENGTH = _NUMBERS[4]
_STAMP = struct.Struct("<II")
MAX_HEADER_SIZE = 1 << 20
"""The greatest size of a record's header that is read [bytes]."""


class DamagedRecordError(ValueError):
    """A record is not as its kind requires; the text has the reason."""


class Record(NamedTuple):
    """A record, in bytes or in a file."""

    fields: Mapping[str, bytes]
    begin: int
    """Offset of its data."""
    size: int
    """Of its data [bytes]."""

    @property
    def kind(self) -> int:
        """What it is, as MESSAGE."""
        return self.number("op", 1)

    @property
    def end(self) -> int:
        """Where its data ends, and the next record begins."""
        return self.begin + self.size

    def number(self, name: str, size: int) -> int:
        """Return a field with an integer of `size` bytes."""
        value = self.fields.get(name, b"")
        if len(value) != size:
            raise DamagedRecordError(f"the field '{name}' of a record has {len(value)} bytes, not {size}")
        (number,) = _NUMBERS[size].unpack(value)
        return int(number)

    def stamp_ns(self, name: str = "time") -> int:
        """Return a field with a time [ns since epoch]."""
        _ = self.number(name, 8)
        seconds, rest = _STAMP.unpack(self.fields[name])
        return int(seconds) * 1_000_000_000 + int(rest)


def record_at(file: io.FileIO, at: int) -> Record | None:
    """Return the record at an offset in a file; None if the file ends in its header."""
    start = read_at(file, at, BLOCK >> 10)
    if len(start) < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack_from(start)
    if length > MAX_HEADER_SIZE:
        raise DamagedRecordError(f"a record's header has {length} bytes")
    if len(start) < length + 2 * _LENGTH.size:
        start = read_at(file, at, length + 2 * _LENGTH.size)
    record = next_record(start, 0)
    return None if record is None else record._replace(begin=at + record.begin)


def next_record(data: bytes, at: int) -> Record | None:
    """Return the record at an offset in bytes, which may lack its data; None if they end in its header."""
    if len(data) - at < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack_from(data, at)
    begin = at + _LENGTH.size + length + _LENGTH.size
    if begin > len(data):
        return None
    header = data[at + _LENGTH.size : begin - _LENGTH.size]
    return Record(read_fields(header), begin, *_LENGTH.unpack_from(data, begin - _LENGTH.size))


def records(data: bytes, at: int) -> Iterator[Record]:
    """Yield the whole records in bytes."""
    while (record := next_record(data, at)) is not None and record.end <= len(data):
        yield record
        at = record.end


def read_fields(header: bytes) -> dict[str, bytes]:
    """Return the fields of a header: each is its length, its name, `=` and its value."""
    fields = {}
    at = 0
    while at < len(header):
        begin = at + _LENGTH.size
        if begin > len(header):
            raise DamagedRecordError("a header ends in the length of a field")
        (length,) = _LENGTH.unpack_from(header, at)
        at = begin + length
        name, sign, value = header[begin:at].partition(b"=")
        if at > len(header) or not sign:
            raise DamagedRecordError(f"a field of {length} bytes is none")
        fields[name.decode("ascii", "replace")] = value
    return fields


def records_of_file(file: io.FileIO, at: int, end: int, size: int = BLOCK) -> Iterator[tuple[Record, bytes]]:
    """Yield the records of a part of a file, and the data of each.

    Args:
        file: The open file.
        at: Where the first one begins.
        end: Where the last one ends.
        size: How much is read at once [bytes].

    Raises:
        DamagedRecordError: the records don't end there, or one of them is damaged.
    """
    while at < end:
        block = read_at(file, at, min(size, end - at))
        following = 0
        for record in records(block, 0):
            yield record, block[record.begin : record.end]
            following = record.end
        if not following:  # one that is larger than the block
            large = record_at(file, at)
            if large is None or large.end > end:
                raise DamagedRecordError(f"the record at byte {at} isn't whole")
            yield large, read_at(file, large.begin, large.size)
            following = large.end - at
        at += following
