"""The records of MCAP files: fields with little-endian numbers, each length checked against the bytes that are left.

https://mcap.dev/spec
"""

from __future__ import annotations

import struct
from typing import NamedTuple

__all__ = ["Channel", "ChunkIndex", "Fields", "Footer", "Opcode", "Schema", "Statistics"]

MAGIC = b"\x89MCAP0\r\n"
RECORD_HEADER = struct.Struct("<BQ")
FOOTER_SIZE = RECORD_HEADER.size + 20 + len(MAGIC)
"""From the footer record to the end of the file [bytes]."""

METADATA_NAME = "rosbag2"
"""Of the metadata records that rosbag2 writes."""
METADATA_KEY = "serialized_metadata"
"""Of the value in them, the content of metadata.yaml."""


def record_header(data: bytes) -> tuple[int, int]:
    """Return the opcode of a record and the length of its content [bytes]; RecordError if the bytes end before."""
    opcode, length = Fields(data).numbers("BQ")
    return opcode, length


class Opcode:  # no enum, because numbers of files are compared with these for each record
    """The first byte of a record, which tells its kind."""

    HEADER = 0x01
    FOOTER = 0x02
    SCHEMA = 0x03
    CHANNEL = 0x04
    MESSAGE = 0x05
    CHUNK = 0x06
    MESSAGE_INDEX = 0x07
    CHUNK_INDEX = 0x08
    ATTACHMENT = 0x09
    ATTACHMENT_INDEX = 0x0A
    STATISTICS = 0x0B
    METADATA = 0x0C
    METADATA_INDEX = 0x0D
    SUMMARY_OFFSET = 0x0E
    DATA_END = 0x0F


class RecordError(ValueError):
    """A record's content is not as its kind requires; the text has the reason."""


class Fields:
    """The content of a record, read in order.

    Each method raises RecordError if the bytes end before.
    """

    def __init__(self, data: bytes) -> None:
        self._data = data
        self.at = 0

    def take(self, size: int) -> bytes:
        """Return the next bytes, and go on behind them; raise RecordError if fewer are left."""
        left = len(self._data) - self.at
        if size > left:
            raise RecordError(f"{size} bytes are needed, {left} are left in the record")
        self.at += size
        return self._data[self.at - size : self.at]

    def numbers(self, form: str) -> tuple[int, ...]:
        """Return integers, by their codes in the module struct."""
        layout = struct.Struct("<" + form)
        return layout.unpack(self.take(layout.size))

    def number(self, form: str) -> int:
        """Return the next integer, in a form of `struct`."""
        return self.numbers(form)[0]

    def data(self) -> bytes:
        """Return bytes that follow their length."""
        return self.take(self.number("I"))

    def text(self) -> str:
        """Return a string; it must be UTF-8."""
        try:
            return self.data().decode()
        except UnicodeDecodeError:
            raise RecordError("the text is not UTF-8") from None

    def part(self) -> Fields:
        """Return the fields of an array or a map, which follow its length."""
        return Fields(self.data())

    @property
    def is_at_end(self) -> bool:
        """Whether all has been read."""
        return self.at >= len(self._data)

    def texts(self) -> dict[str, str]:
        """Return a map of strings."""
        part = self.part()
        texts = {}
        while not part.is_at_end:
            key = part.text()
            texts[key] = part.text()
        return texts

    def pairs(self, form: str) -> list[tuple[int, ...]]:
        """Return an array of several integers each."""
        data = self.data()
        layout = struct.Struct("<" + form)
        if len(data) % layout.size:
            raise RecordError(f"an array of {len(data)} bytes has elements of {layout.size} bytes")
        return list(layout.iter_unpack(data))

    def counts(self, form: str) -> dict[int, int]:
        """Return a map of integers."""
        return {pair[0]: pair[1] for pair in self.pairs(form)}


class Header(NamedTuple):
    """The content of the first record of a file."""

    profile: str
    library: str

    @classmethod
    def read(cls, data: bytes) -> Header:
        """Return the record of this content."""
        fields = Fields(data)
        return cls(fields.text(), fields.text())


class Footer(NamedTuple):
    """The content of the last record of a finished file."""

    summary_start: int
    """Offset of the summary; 0 if there is none."""

    @classmethod
    def read(cls, data: bytes) -> Footer:
        """Return the record of this content."""
        return cls(Fields(data).numbers("QQI")[0])


class Schema(NamedTuple):
    """A record of the file that defines a type."""

    id: int
    name: str
    encoding: str
    data: bytes

    @classmethod
    def read(cls, data: bytes) -> Schema:
        """Return the record of this content."""
        fields = Fields(data)
        return cls(fields.number("H"), fields.text(), fields.text(), fields.data())


class Channel(NamedTuple):
    """A record of the file that defines a topic; messages refer to it by its number."""

    id: int
    schema_id: int
    """0 if it has no schema."""
    topic: str
    encoding: str
    metadata: dict[str, str]

    @classmethod
    def read(cls, data: bytes) -> Channel:
        """Return the record of this content."""
        fields = Fields(data)
        number, schema = fields.numbers("HH")
        return cls(number, schema, fields.text(), fields.text(), fields.texts())


class ChunkHeader(NamedTuple):
    """The beginning of a chunk record."""

    start_ns: int
    end_ns: int
    size: int
    """Decompressed [bytes]."""
    crc: int
    compression: str
    stored_size: int
    """Compressed [bytes]."""
    data_offset: int
    """Of the compressed bytes, in the record's content."""

    @classmethod
    def read(cls, data: bytes) -> ChunkHeader:
        """Return the record whose content begins with these bytes."""
        fields = Fields(data)
        start, end, size, crc = fields.numbers("QQQI")
        return cls(start, end, size, crc, fields.text(), fields.number("Q"), fields.at)


class ChunkIndex(NamedTuple):
    """Where a chunk is, and what it has."""

    start_ns: int
    end_ns: int
    offset: int
    """Of the chunk record in the file."""
    length: int
    """Of the chunk record [bytes]."""
    index_offsets: dict[int, int]
    """Offset of the message index record of each channel, by channel; empty if there are none."""
    index_length: int
    """Of all message index records [bytes]."""
    compression: str
    stored_size: int
    size: int
    """Decompressed [bytes]."""

    @classmethod
    def read(cls, data: bytes) -> ChunkIndex:
        """Return the record of this content."""
        fields = Fields(data)
        start, end, offset, length = fields.numbers("QQQQ")
        offsets = fields.counts("HQ")
        index_length = fields.number("Q")
        compression = fields.text()
        return cls(start, end, offset, length, offsets, index_length, compression, *fields.numbers("QQ"))


class MetadataIndex(NamedTuple):
    """Where a metadata record is."""

    offset: int
    name: str

    @classmethod
    def read(cls, data: bytes) -> MetadataIndex:
        """Return the record of this content."""
        fields = Fields(data)
        offset, _length = fields.numbers("QQ")
        return cls(offset, fields.text())


class Statistics(NamedTuple):
    """Counts of the file's records."""

    message_count: int
    chunk_count: int
    start_ns: int
    end_ns: int
    counts: dict[int, int]
    """Messages by channel."""

    @classmethod
    def read(cls, data: bytes) -> Statistics:
        """Return the record of this content."""
        fields = Fields(data)
        messages, _schemas, _channels, _attachments, _metadata, chunks = fields.numbers("QHIIII")
        start, end = fields.numbers("QQ")
        return cls(messages, chunks, start, end, fields.counts("HQ"))


def read_message_index(data: bytes) -> tuple[int, list[tuple[int, ...]]]:
    """Return the channel of a message index record, and log time and offset of each of its messages in the chunk."""
    fields = Fields(data)
    return fields.number("H"), fields.pairs("QQ")
