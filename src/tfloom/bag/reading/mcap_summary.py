"""The layout of an MCAP file by its summary, or by a walk over its records where it has none."""

from __future__ import annotations

import io
import warnings
from collections import Counter
from itertools import pairwise
from pathlib import Path

from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.reading import mcap_records as records
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.mcap_layout import Layout, Span
from tfloom.bag.reading.mcap_records import Opcode, RecordError
from tfloom.bag.reading.mcap_scan import Scan

__all__ = ["read_layout"]

CHECKSUM_OF_CHUNK = 33
"""From the beginning of a chunk record to its checksum [bytes]."""
INDEX_OF_CHUNK = 49
"""From the beginning of a chunk record to its compressed bytes, without the compression's name [bytes]."""
EMPTY_INDEX_SIZE = 64
"""Of the content of a chunk's index without compression and message indexes [bytes]."""
_SIZES = 16
"""Of the sizes of a chunk at the end of its index [bytes]."""


def read_layout(file: io.FileIO, path: Path) -> Layout:
    """Return the layout of a file, by its summary if it has one.

    Raises:
        BagError: it is not an MCAP file, or damaged.
        OSError: it can't be read.
    """
    size = file.seek(0, io.SEEK_END)
    header = _read_header(file, path, size)
    end = read_at(file, max(0, size - records.FOOTER_SIZE), records.FOOTER_SIZE)
    is_finished = end.endswith(records.MAGIC) and end[:9] == records.RECORD_HEADER.pack(Opcode.FOOTER, 20)
    try:
        summary = records.Footer.read(end[9:29]).summary_start if is_finished else 0
        if summary and (layout := _read_summary(file, header, summary, size)):
            return layout
    except RecordError as error:
        warnings.warn(BagWarning(f"{path}: the summary is damaged, and isn't used: {error}"), stacklevel=2)
    # The layout that the summary has begun is not used: the walk begins with an empty one.
    scan = Scan(file, path, Layout(header))
    scan.run()
    return scan.layout


def _read_header(file: io.FileIO, path: Path, size: int) -> records.Header:
    start = read_at(file, 0, 1 << 16)
    if not start:
        raise BagError(path, "the file is empty: its recorder ended before it wrote anything")
    if not start.startswith(records.MAGIC):
        if records.MAGIC.startswith(start):
            raise BagError(path, f"the file ends after {size} bytes, within the first bytes of an MCAP file")
        raise BagError(path, f"this is not an MCAP file: it begins with {start[:8]!r}", 0)
    try:
        fields = records.Fields(start[len(records.MAGIC) :])
        opcode, length = fields.numbers("BQ")
        if opcode != Opcode.HEADER:
            raise BagError(
                path, f"the first record of an MCAP file is its header, not one of kind {opcode}", 8
            )
        return records.Header.read(fields.take(length))
    except RecordError as error:
        raise BagError(path, f"the header is damaged or cut off: {error}", 8) from None


def _read_summary(file: io.FileIO, header: records.Header, start: int, size: int) -> Layout | None:
    """Return what the summary says; None if it isn't enough to read the messages.

    Raises:
        RecordError: it is damaged.
    """
    layout = Layout(header)
    statistics: records.Statistics | None = None
    spans: list[Span] = []
    chunks = 0
    fields = records.Fields(read_at(file, start, size - len(records.MAGIC) - start))
    while not fields.is_at_end:
        opcode, length = fields.numbers("BQ")
        content = fields.take(length)
        if opcode == Opcode.CHUNK_INDEX:
            chunks += 1
            spans += _spans_of_index(content, chunks, start)
        elif opcode == Opcode.STATISTICS:
            statistics = records.Statistics.read(content)
        elif opcode == Opcode.METADATA_INDEX:
            metadata = records.MetadataIndex.read(content)
            layout.metadata_offsets.append((metadata.name, metadata.offset))
        else:
            layout.add(opcode, content)
    # Some writers leave out parts of the summary, as the format allows. Without statistics, or with fewer chunk indexes
    # than chunks, nobody knows what would be missing, so the file is walked over.
    _check_overlaps(spans, start)
    if statistics is None or chunks != statistics.chunk_count:
        return None
    if statistics.message_count and not layout.channels:
        return None
    layout.counts = Counter(statistics.counts)
    layout.start_ns, layout.end_ns = statistics.start_ns, statistics.end_ns
    # Messages without any chunk are found by a walk, but not before they are asked for: topics and times are known.
    if chunks or not statistics.message_count:
        layout.spans = spans
    return layout


def _check_overlaps(spans: list[Span], limit: int) -> None:
    """Raise RecordError unless chunks follow each other, each with its indexes, so that no byte is read for several."""
    # A small file could otherwise name the same large chunk a million times, and each would be decompressed. The limit
    # of a chunk with its indexes is the record of the next one; of the last, the summary.
    in_file = sorted(spans, key=lambda span: span.offset)
    for one, other in pairwise(in_file):
        if one.offset + one.stored_size + INDEX_OF_CHUNK > other.offset:
            raise RecordError(f"the chunks at bytes {one.offset} and {other.offset} overlap")
    limits = [*(span.offset - INDEX_OF_CHUNK for span in in_file[1:]), limit]
    for span, end in zip(in_file, limits, strict=False):  # without chunks there is one limit too many
        begin = span.offset + span.stored_size
        offsets = span.index_offsets.values()
        if begin + span.index_length > end or (offsets and (min(offsets) < begin or max(offsets) >= end)):
            raise RecordError(f"the message indexes of the chunk at byte {span.offset} aren't behind it")


def _spans_of_index(content: bytes, number: int, limit: int) -> list[Span]:
    """Return the span of the index of a chunk; none if the chunk is empty.

    A million empty chunks would take 400 MB as spans.
    """
    if number * INDEX_OF_CHUNK > limit:
        raise RecordError(f"it names {number} chunks, more than fit before it")
    if _is_empty(content):
        return []
    index = records.ChunkIndex.read(content)
    return [_span_of_index(index, limit)] if index.size else []


def _is_empty(content: bytes) -> bool:
    """Return whether the index of a chunk says at once that it is empty, without compression and indexes."""
    return (
        len(content) == EMPTY_INDEX_SIZE
        and content[-_SIZES:] == bytes(_SIZES)
        and content[32:36] == bytes(4)  # no message indexes
    )


def _span_of_index(index: records.ChunkIndex, limit: int) -> Span:
    offset = index.offset + INDEX_OF_CHUNK + len(index.compression.encode())
    if offset + index.stored_size > limit:
        raise RecordError(f"a chunk at byte {index.offset} would end after the messages")
    channels = frozenset(index.index_offsets) if index.index_offsets else None
    return Span(
        index.start_ns,
        index.end_ns,
        offset,
        index.stored_size,
        index.compression,
        index.size,
        index.index_offsets,
        channels,
        index.offset + CHECKSUM_OF_CHUNK,
        index_length=index.index_length,
        are_times_declared=True,
    )
