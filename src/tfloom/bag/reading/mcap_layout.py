"""Where the messages of an MCAP file are."""

from __future__ import annotations

import io
import struct
import warnings
import zlib
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from tfloom import _native
from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.reading import mcap_records as records
from tfloom.bag.reading.compression import CompressionError, DamagedError, decompress, decompress_part
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.mcap_implausible import check_plausible
from tfloom.bag.reading.mcap_records import Opcode
from tfloom.bag.values import EARLIEST, LATEST

__all__ = ["Layout", "Span", "decompressed", "warn_of_damage", "whole_records"]

CHECKSUM = struct.Struct("<I")


class Span(NamedTuple):
    """A part of a file that has messages: a chunk, or messages outside of chunks."""

    start_ns: int
    """The least log time [ns since epoch]."""
    end_ns: int
    """The greatest one [ns since epoch]."""
    offset: int
    """Of the stored bytes in the file."""
    stored_size: int
    """How many there are [bytes]."""
    compression: str
    size: int
    """Decompressed [bytes]."""
    index_offsets: dict[int, int]
    """Offset of the message index of each channel; empty if there is none."""
    channels: frozenset[int] | None
    """The channels of the messages; None if they aren't known."""
    checksum_offset: int | None = None
    """Of the checksum of the decompressed bytes in the file; None if there is none."""
    is_whole: bool = True
    """Whether the file has all of it; False for what is at the end of an unfinished file."""
    index_length: int = 0
    """Of all its message indexes, which follow it in the file [bytes]; 0 if there are none."""
    are_times_declared: bool = False
    """Whether the times are what the chunk declares; False: they are those of its messages."""


class Layout:
    """What an MCAP file consists of.

    Attributes:
        schemas: By id.
        channels: By id.
        counts: Messages by channel.
        start_ns: The least log time [ns since epoch]; 0 without messages.
        end_ns: The greatest one [ns since epoch].
        spans: The parts that have messages, in the order of the file; None if they aren't known yet.
        metadata_offsets: Where the metadata records are, with their names.
    """

    def __init__(self, header: records.Header) -> None:
        self.header = header
        self.schemas: dict[int, records.Schema] = {}
        self.channels: dict[int, records.Channel] = {}
        self.counts: Counter[int] = Counter()
        self.start_ns = 0
        self.end_ns = 0
        self.spans: list[Span] | None = None
        self.metadata_offsets: list[tuple[str, int]] = []

    def add(self, opcode: int, content: bytes) -> None:
        """Add a schema or a channel.

        Raises:
            RecordError: its content isn't as its kind requires.
        """
        if opcode == Opcode.SCHEMA:
            schema = records.Schema.read(content)
            self.schemas[schema.id] = schema
        elif opcode == Opcode.CHANNEL:
            channel = records.Channel.read(content)
            self.channels[channel.id] = channel


def decompressed(file: io.FileIO, path: Path, span: Span, size: int | None = None) -> bytes | None:
    """Return the records of a span.

    Args:
        file: The open file.
        path: Its path, for errors.
        span: The part of the file.
        size: How many bytes are needed; None: all.

    Returns:
        The bytes; None, after a warning, if they are damaged.

    Raises:
        BagError: they can't be decompressed, because the compression is unknown, or its library isn't installed.
    """
    if span.compression not in {"", "lz4", "zstd"}:
        reason = f"the compression is '{span.compression[:40]}', which is none of lz4 and zstd"
        raise BagError(path, reason, span.offset)
    stored = read_at(file, span.offset, span.stored_size)
    try:
        check_plausible(span.compression, stored, span.size, span.is_whole)
        # Of a chunk that is cut off, as of one whose beginning is enough, less comes out than it declares. All others
        # must have their declared size, or they are damaged.
        if not span.is_whole or size is not None:
            return decompress_part(span.compression, stored, span.size if size is None else size)
        return decompress(span.compression, stored, span.size)
    except DamagedError as error:
        warn_of_damage(path, span, str(error))
        return None
    except CompressionError as error:
        raise BagError(path, str(error), span.offset) from None


def whole_records(file: io.FileIO, path: Path, span: Span) -> bytes:
    """Return the whole records of a span; none, after a warning, if they are damaged.

    Raises:
        BagError: as `decompressed`.
    """
    # The checksum is of all bytes, so a chunk that is cut off has none that fits. Its whole records are read without.
    data = decompressed(file, path, span) or b""
    if span.is_whole and not _has_checksum(file, span, data):
        warn_of_damage(path, span, "its content does not have its checksum")
        return b""
    try:
        counts, first, last, _, end = _native.summarise_mcap(data, 0)
    except ValueError as error:
        warn_of_damage(path, span, str(error))
        return b""
    if counts and (first < span.start_ns or last > min(span.end_ns, LATEST)):
        _warn_of_times(path, span, data, counts)
    # After the last whole record, a chunk that is cut off has the beginning of another one, as expected. Anywhere else
    # that is damage.
    if end != len(data) and span.is_whole:
        warn_of_damage(path, span, f"it has no whole record at byte {end}", "it is read up to there")
    return data[:end] if end != len(data) else data


def _warn_of_times(path: Path, span: Span, data: bytes, counts: Mapping[int, int]) -> None:
    """Warn of the messages whose log times aren't within those of their chunk, by which chunks are chosen."""
    times = max(span.start_ns, EARLIEST), min(span.end_ns, LATEST)
    try:
        outside = sum(counts.values()) - len(_native.list_mcap_messages(data, list(counts), *times))
    except ValueError:
        return  # the reader warns of it
    reason = f"{outside} of its messages have log times outside those that it declares"
    warn_of_damage(path, span, reason, "a part of the bag, chosen by times, may lack them")


def _has_checksum(file: io.FileIO, span: Span, data: bytes) -> bool:
    """Return whether the records of a chunk have its CRC-32; True if it has none."""
    if span.checksum_offset is None or not data:
        return True
    (checksum,) = CHECKSUM.unpack(read_at(file, span.checksum_offset, CHECKSUM.size))
    return checksum in {0, zlib.crc32(data)}


def warn_of_damage(path: Path, span: Span, reason: str, then: str = "it is left out") -> None:
    """Warn that a span is damaged."""
    text = f"{path}: byte {span.offset}: a chunk of messages is damaged: {reason}; {then}"
    warnings.warn(BagWarning(text), stacklevel=2)
