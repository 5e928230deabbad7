"""The layout of an MCAP file without a summary: a walk over its records, up to the last whole one."""

from __future__ import annotations

import io
import warnings
from pathlib import Path

from tfloom import _native
from tfloom.bag.errors import BagWarning
from tfloom.bag.reading import mcap_records as records
from tfloom.bag.reading.compression import MOST
from tfloom.bag.reading.file_bytes import BLOCK, read_at
from tfloom.bag.reading.mcap_layout import Layout, Span, decompressed, warn_of_damage
from tfloom.bag.reading.mcap_records import RECORD_HEADER, Opcode, RecordError

__all__ = ["Scan"]

LOOSE = (Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE)
PEEK = 1 << 12
"""How much is read at least of a record's beginning [bytes]."""
CHUNK_HEADER_SIZE = 256
"""Enough for a chunk's numbers and the name of its compression [bytes]."""


class Scan:
    """A walk over all records of a file.

    Args:
        file: The open file.
        path: Its path, for warnings.
        layout: What is found is added to it.
    """

    def __init__(self, file: io.FileIO, path: Path, layout: Layout) -> None:
        self.layout = layout
        self._file = file
        self._path = path
        self._size = file.seek(0, io.SEEK_END)
        self._block = b""
        self._block_at = 0
        self._peeked = b""
        self._peeked_at = 0
        self._spans: list[Span] = []
        self._times: list[int] = []
        self._is_ended = False
        self._chunk: Span | None = None

    def run(self) -> None:
        """Walk from the header to the end of the messages."""
        at = len(records.MAGIC)
        try:
            while not self._is_ended and self._size - at >= RECORD_HEADER.size:
                at = self._read(at)
        except RecordError as error:
            self._warn(f"is read up to byte {at}, because what follows is damaged: {error}")
        else:
            if not self._is_ended:
                self._warn("has no end, because it is still being written or its recorder was killed")
        self.layout.spans = self._spans
        if self._times:
            self.layout.start_ns, self.layout.end_ns = min(self._times), max(self._times)

    def _warn(self, reason: str) -> None:
        count = self.layout.counts.total()
        text = f"{self._path}: the file {reason}; {count} messages are read, to the last whole one"
        warnings.warn(BagWarning(text), stacklevel=2)

    def _read(self, at: int) -> int:
        """Read the record at an offset; return that of the next one."""
        opcode, length = records.record_header(self._peek(at, RECORD_HEADER.size))
        if opcode in LOOSE:
            return self._read_loose(at, length)
        content = at + RECORD_HEADER.size
        if opcode == Opcode.CHUNK:
            self._read_chunk(content, min(length, self._size - content))
        elif opcode in {Opcode.DATA_END, Opcode.FOOTER}:
            self._is_ended = True
        elif opcode == Opcode.METADATA and content + length <= self._size:
            name = records.Fields(read_at(self._file, content, length)).text()
            self.layout.metadata_offsets.append((name, at))
        # The indexes of a chunk follow it. Those after a chunk that is left out belong to none.
        elif opcode == Opcode.MESSAGE_INDEX and self._chunk and content + length <= self._size:
            channel = records.Fields(self._peek(content, min(length, 2))).number("H")
            self._chunk.index_offsets[channel] = at
        elif opcode == 0:
            raise RecordError("there is no record of kind 0")
        return content + length

    def _peek(self, at: int, size: int) -> bytes:
        """Return a few bytes; small records that follow each other are read at once."""
        begin = at - self._peeked_at
        if not 0 <= begin <= len(self._peeked) - size:
            self._peeked, self._peeked_at = read_at(self._file, at, max(PEEK, size)), at
            begin = 0
        return self._peeked[begin : begin + size]

    def _read_loose(self, at: int, length: int) -> int:
        """Read messages, schemas and channels that aren't in a chunk, of one block; return the offset after them."""
        size = RECORD_HEADER.size + length
        if size > self._size - at:
            return self._size  # the last record isn't whole
        if size > MOST:
            raise RecordError(f"a record of {size} bytes is there, more than the {MOST} that are accepted")
        # A block has many small messages. It grows to the record if that is larger, so that each step makes progress.
        if at + size > self._block_at + len(self._block):
            self._block, self._block_at = read_at(self._file, at, max(BLOCK, size)), at
        end = self._add_records(self._block, at - self._block_at, Span(0, 0, at, 0, "", 0, {}, None))
        if end == at - self._block_at:
            return self._size  # the file has become shorter meanwhile
        self._chunk = None
        return self._block_at + end

    def _add_records(self, data: bytes, begin: int, span: Span) -> int:
        """Add the records of a span, which begins in some bytes; return where it ends in them."""
        try:
            counts, first, last, others, end = _native.summarise_mcap(data, begin)
        except ValueError as error:
            raise RecordError(str(error)) from None
        for opcode, offset, size in others:
            self.layout.add(opcode, data[offset : offset + size])
        if not span.size:
            span = span._replace(stored_size=end - begin, size=end - begin)
        if counts:
            self.layout.counts.update(counts)
            self._times += [first, last]
            self._spans.append(span._replace(start_ns=first, end_ns=last, channels=frozenset(counts)))
        return end

    def _read_chunk(self, at: int, left: int) -> None:
        """Read a chunk whose record has its content at an offset, and this many bytes of it in the file."""
        self._chunk = None
        try:
            header = records.ChunkHeader.read(self._peek(at, min(left, CHUNK_HEADER_SIZE)))
        except RecordError:
            if left < CHUNK_HEADER_SIZE:
                return  # the file ends in it
            raise
        if not (header.size or header.stored_size):
            return
        # The last chunk of a file without an end may be cut off. What is there of it is read, to its last whole record.
        stored = min(header.stored_size, left - header.data_offset)
        is_whole = stored == header.stored_size
        offset = at + header.data_offset
        span = Span(0, 0, offset, stored, header.compression, header.size, {}, None, at + 24, is_whole)
        data = decompressed(self._file, self._path, span)
        if not data:
            return
        # The records tell their times and channels, which the chunk's header doesn't, or not reliably. A message index
        # after this chunk adds its offset to the span that is in the list, by the dict that they share.
        self._chunk = span
        try:
            self._add_records(data, 0, span)
        except RecordError as error:
            self._chunk = None
            warn_of_damage(self._path, span, str(error))
