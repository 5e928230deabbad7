"""The bytes of MCAP's records; every integer is little-endian."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from tfloom.bag.reading.mcap_records import Opcode

__all__ = ["ChunkPlace", "McapChannel", "MetadataPlace"]


class McapChannel(NamedTuple):
    """What the record of a channel says."""

    number: int
    """From 1."""
    schema_number: int
    """From 1."""
    topic: str
    encoding: str
    metadata: Mapping[str, str]


class ChunkPlace(NamedTuple):
    """Where a chunk and its message indexes are in the file, and what the summary says of them."""

    start_ns: int
    end_ns: int
    offset: int
    length: int
    index_offsets: Mapping[int, int]
    """By channel."""
    index_length: int
    compression: str
    compressed_size: int
    size: int


class MetadataPlace(NamedTuple):
    """Where a metadata record is in the file, for the summary."""

    offset: int
    length: int
    name: str


def record(opcode: int, content: bytes) -> bytes:
    """Return a record: opcode, length, content."""
    return struct.pack("<BQ", opcode, len(content)) + content


def text(value: str) -> bytes:
    """Return a string with its length before it."""
    encoded = value.encode()
    return struct.pack("<I", len(encoded)) + encoded


def string_map(values: Mapping[str, str]) -> bytes:
    """Return a map of strings with its length before it."""
    content = b"".join(text(key) + text(value) for key, value in values.items())
    return struct.pack("<I", len(content)) + content


def header(profile: str, library: str) -> bytes:
    """Return the first record of a file."""
    return record(Opcode.HEADER, text(profile) + text(library))


def schema(number: int, name: str, encoding: str, definition: str) -> bytes:
    """Return the record of a schema."""
    content = struct.pack("<H", number) + text(name) + text(encoding) + text(definition)
    return record(Opcode.SCHEMA, content)


def channel(values: McapChannel) -> bytes:
    """Return the record of a channel."""
    content = struct.pack("<HH", values.number, values.schema_number) + text(values.topic)
    return record(Opcode.CHANNEL, content + text(values.encoding) + string_map(values.metadata))


def metadata(name: str, values: Mapping[str, str]) -> bytes:
    """Return a metadata record."""
    return record(Opcode.METADATA, text(name) + string_map(values))


def chunk_head(start_ns: int, end_ns: int, sizes: tuple[int, int], crc: int, compression: str) -> bytes:
    """Return a chunk's record up to its compressed content, whose size and compressed size are given."""
    size, compressed_size = sizes
    fields = struct.pack("<qqQI", start_ns, end_ns, size, crc) + text(compression)
    length = len(fields) + 8 + compressed_size
    return struct.pack("<BQ", Opcode.CHUNK, length) + fields + struct.pack("<Q", compressed_size)


def message_index(number: int, entries: bytes) -> bytes:
    """Return the index of a channel in the chunk before; `entries` are pairs of log time and offset."""
    return record(Opcode.MESSAGE_INDEX, struct.pack("<HI", number, len(entries)) + entries)


def chunk_index(place: ChunkPlace) -> bytes:
    """Return the summary's record of a chunk."""
    offsets = b"".join(struct.pack("<HQ", *item) for item in place.index_offsets.items())
    return record(
        Opcode.CHUNK_INDEX,
        struct.pack("<qqQQI", place.start_ns, place.end_ns, place.offset, place.length, len(offsets))
        + offsets
        + struct.pack("<Q", place.index_length)
        + text(place.compression)
        + struct.pack("<QQ", place.compressed_size, place.size),
    )


def metadata_index(place: MetadataPlace) -> bytes:
    """Return the summary's record of a metadata record."""
    return record(Opcode.METADATA_INDEX, struct.pack("<QQ", place.offset, place.length) + text(place.name))


def statistics(
    counts: Mapping[int, int], times: tuple[int, int], *, schemas: int, metadata: int, chunks: int
) -> bytes:
    """Return the statistics: messages by channel, the smallest and the greatest log time, numbers of records."""
    per_channel = b"".join(struct.pack("<HQ", *item) for item in counts.items())
    fields = struct.pack(
        "<QHIIIIqqI",
        sum(counts.values()),
        schemas,
        len(counts),
        0,
        metadata,
        chunks,
        *times,
        len(per_channel),
    )
    return record(Opcode.STATISTICS, fields + per_channel)


def summary_offsets(groups: Iterable[tuple[int, int, int]]) -> bytes:
    """Return the records of where each group of the summary is: opcode, start, length."""
    return b"".join(record(Opcode.SUMMARY_OFFSET, struct.pack("<BQQ", *group)) for group in groups)


def footer_before_crc(summary_start: int, summary_offset_start: int) -> bytes:
    """Return the last record up to the CRC, which covers these bytes too."""
    return struct.pack("<BQQQ", Opcode.FOOTER, 20, summary_start, summary_offset_start)
