"""The layout of a ROS 1 bag by its index: the records at its end, and those after each chunk."""

from __future__ import annotations

import io
import struct
from collections import Counter
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tfloom.bag.errors import BagError
from tfloom.bag.reading.ros1_layout import Ros1Layout, Span, compression_of
from tfloom.bag.reading.ros1_records import (
    BAG_HEADER,
    CHUNK,
    CHUNK_INFO,
    CONNECTION,
    INDEX,
    MAGIC,
    DamagedRecordError,
    Record,
    record_at,
    records_of_file,
)

__all__ = ["has_index", "read_index"]

_VERSION = 1
"""Of chunk infos and index records."""
_INDEX_SIZE = 55
"""Of an index record without its entries [bytes], as rosbag writes it."""
_COUNT = struct.Struct("<II")
_ENTRY_SIZE = 12
"""Of one message's entry in an index record [bytes]."""


class _ChunkInfo(NamedTuple):
    offset: int
    """Of the chunk's record in the file."""
    counts: Counter[int]
    """Messages of each connection."""


def has_index(file: io.FileIO, layout: Ros1Layout) -> bool:
    """Return whether the header of a bag names an index within the file.

    Raises:
        BagError: the header is damaged, or the bag is encrypted.
    """
    try:
        header = record_at(file, len(MAGIC))
        if header is None or header.kind != BAG_HEADER:
            raise BagError(layout.path, "the bag has no header, because it is damaged or cut off", len(MAGIC))
        place = header.number("index_pos", 8)
    except DamagedRecordError as error:
        raise BagError(layout.path, f"the bag's header is damaged: {error}", len(MAGIC)) from None
    if encryptor := header.fields.get("encryptor", b"").decode("utf-8", "replace"):
        raise BagError(layout.path, f"the bag is encrypted by '{encryptor[:40]}': decrypt it by rosbag")
    # The index of a bag without connections has no bytes: it ends where it begins.
    size = file.seek(0, io.SEEK_END)
    is_empty = header.fields.get("conn_count") == header.fields.get("chunk_count") == bytes(4)
    return 0 < place < size + is_empty


def read_index(file: io.FileIO, layout: Ros1Layout) -> None:
    """Read what the index says.

    A chunk whose own index doesn't fit is read itself, and one that isn't where the index says is left out, after a
    warning.

    Raises:
        DamagedRecordError: the index is damaged; nothing but connections is in the layout.
        BagError: a chunk can't be decompressed, because the compression is unknown, or its library isn't installed.
    """
    header = record_at(file, len(MAGIC))
    if header is None:
        raise DamagedRecordError("the bag's header is cut off")
    place = header.number("index_pos", 8)
    infos = _read_infos(file, layout, place)
    if len(infos) != header.number("chunk_count", 4):
        raise DamagedRecordError(
            f"it has {len(infos)} chunks, and the bag's header {header.number('chunk_count', 4)}"
        )
    # A chunk and its index records end before the next chunk, the last one's before the index. These limits keep a
    # damaged size from reaching into another chunk.
    infos.sort(key=lambda info: info.offset)
    limits = [*(info.offset for info in infos[1:]), place][: len(infos)]
    for info, other in pairwise(infos):
        if info.offset == other.offset:  # else a few bytes would stand for any number of chunks
            raise DamagedRecordError(f"it names the chunk at byte {info.offset} twice")
    for info, limit in zip(infos, limits, strict=True):
        _add_chunk(file, layout, info, limit)
    layout.warn_of_unknown_connections()


def _read_infos(file: io.FileIO, layout: Ros1Layout, place: int) -> list[_ChunkInfo]:
    infos: list[_ChunkInfo] = []
    for record, data in records_of_file(file, place, file.seek(0, io.SEEK_END)):
        if record.kind == CONNECTION:
            layout.add_connection(record, data)
        elif record.kind == CHUNK_INFO:
            infos.append(_read_info(record, data))
        else:
            raise DamagedRecordError(f"it has a record of kind {record.kind}")
    return infos


def _read_info(record: Record, data: bytes) -> _ChunkInfo:
    if record.number("ver", 4) != _VERSION:
        raise DamagedRecordError(f"a chunk's information has version {record.number('ver', 4)}")
    if len(data) != 8 * record.number("count", 4):
        raise DamagedRecordError(f"a chunk's information has {len(data)} bytes")
    counts: Counter[int] = Counter()
    for connection, count in _COUNT.iter_unpack(data):
        counts[connection] += count
    return _ChunkInfo(record.number("chunk_pos", 8), counts)


def _add_chunk(file: io.FileIO, layout: Ros1Layout, info: _ChunkInfo, limit: int) -> None:
    try:
        record = _chunk_at(file, info.offset, limit)
        size = record.number("size", 4)
    except DamagedRecordError as error:
        layout.warn_of_damage(info.offset, str(error), f"its {info.counts.total()} messages are left out")
        return
    # Three sources describe a chunk: the information at the file's end, the index records behind it, and its content.
    # The first two are enough if they agree, and every connection is described; otherwise the content decides.
    times = _times_of_index(file, info, record.end, limit)
    if times is None or not layout.describes(info.counts):
        layout.add_chunk(file, record)
    elif info.counts:
        layout.counts += info.counts
        span = Span(
            *times,
            record.begin,
            record.size,
            compression_of(record),
            size,
            frozenset(info.counts),
            info.counts.total(),
        )
        layout.spans.append(span)


def _chunk_at(file: io.FileIO, offset: int, limit: int) -> Record:
    record = record_at(file, offset)
    if record is None or record.kind != CHUNK or record.end > limit:
        raise DamagedRecordError("it isn't where the index says")
    return record


def _times_of_index(file: io.FileIO, info: _ChunkInfo, at: int, limit: int) -> tuple[int, int] | None:
    """Return the least and the greatest log time of a chunk; None if its index isn't that of the same messages.

    The times that the information of the chunk declares aren't used: a chunk is left out by them.
    """
    # The size follows from the counts, so that all index records are read at once. It is a guess of other writers'
    # files, whose headers may be longer or shorter: then the counts differ below, and the chunk is read itself.
    size = sum(_INDEX_SIZE + _ENTRY_SIZE * count for count in info.counts.values())
    counts: Counter[int] = Counter()
    least, greatest = [], []
    try:
        for record, data in records_of_file(file, at, min(at + size, limit), size):
            if record.kind != INDEX or record.number("ver", 4) != _VERSION or len(data) % _ENTRY_SIZE:
                return None
            # An entry is seconds, nanoseconds and an offset in the chunk, which isn't needed.
            entries = np.frombuffer(data, "<u4").reshape(-1, 3).astype(np.int64)
            if len(entries):
                stamps_ns = entries[:, 0] * 1_000_000_000 + entries[:, 1]
                least.append(int(stamps_ns.min()))
                greatest.append(int(stamps_ns.max()))
            counts[record.number("conn", 4)] += len(entries)
    except DamagedRecordError:
        return None
    if counts != info.counts:
        return None
    return min(least, default=0), max(greatest, default=0)
