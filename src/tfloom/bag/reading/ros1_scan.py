"""The messages of a ROS 1 bag without an index: a walk over its records, up to the last whole one."""

from __future__ import annotations

import io
import warnings

from tfloom.bag.errors import BagWarning
from tfloom.bag.reading.compression import MOST
from tfloom.bag.reading.file_bytes import BLOCK, read_at
from tfloom.bag.reading.ros1_layout import Ros1Layout, compression_of
from tfloom.bag.reading.ros1_records import (
    BAG_HEADER,
    CHUNK,
    CHUNK_INFO,
    CONNECTION,
    INDEX,
    MAGIC,
    MESSAGE,
    DamagedRecordError,
    Record,
    record_at,
)

__all__ = ["Ros1Scan"]


class Ros1Scan:
    """A walk over all records of a file.

    Args:
        file: The open file.
        layout: What is found is added to it.
        why: Why the index isn't used.
    """

    def __init__(self, file: io.FileIO, layout: Ros1Layout, why: str) -> None:
        self._file = file
        self._layout = layout
        self._why = why
        self._size = file.seek(0, io.SEEK_END)
        self._block = b""
        self._block_at = 0

    def run(self) -> None:
        """Find the connections, and what has messages.

        Raises:
            BagError: a chunk can't be decompressed, because the compression is unknown, or its library isn't installed.
        """
        at = len(MAGIC)
        reason = ""
        try:
            while (record := record_at(self._file, at)) is not None:
                following = self._read(at, record)
                if following is None:
                    break
                at = following
        except DamagedRecordError as error:
            reason = f", and is read up to byte {at}, because what follows is damaged: {error}"
        text = (
            f"{self._layout.path}: {self._why}{reason}; {self._layout.message_count} messages are read, "
            "to the last whole one"
        )
        warnings.warn(BagWarning(text), stacklevel=2)
        self._layout.warn_of_unknown_connections()

    def _read(self, at: int, record: Record) -> int | None:
        """Read the record at an offset; return that of the next one, or None if the file ends in it."""
        if record.kind in {MESSAGE, CONNECTION}:
            return self._read_loose(at, record)
        # A recorder writes a chunk's header with size 0, then its records, and at the chunk's end the size. So the last
        # chunk of a killed recorder may be open: without compression its records are read as if they were loose.
        if record.kind == CHUNK:
            compression = compression_of(record)
            if record.size and record.end <= self._size:
                self._layout.add_chunk(self._file, record)
            elif compression == "none":
                return record.begin
            else:
                return None
        elif record.kind not in {BAG_HEADER, INDEX, CHUNK_INFO}:
            raise DamagedRecordError(f"a record of kind {record.kind} is there")
        return record.end

    def _read_loose(self, at: int, record: Record) -> int | None:
        """Read records that aren't in a chunk, of one block; return the offset after them."""
        size = record.end - at
        if record.end > self._size:
            return None
        if size > MOST:
            raise DamagedRecordError(f"{size} bytes are declared, more than the {MOST} that are accepted")
        if record.end > self._block_at + len(self._block):
            self._block, self._block_at = read_at(self._file, at, max(BLOCK, size)), at
        # The record was within the file a moment ago. If not even one is whole now, the file has become shorter, and
        # the walk would go on forever here.
        begin = at - self._block_at
        end = self._layout.add(self._block, begin, at)
        return None if end == begin else self._block_at + end
