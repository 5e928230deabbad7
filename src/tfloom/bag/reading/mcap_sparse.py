"""Only those bytes of an MCAP chunk that have messages of some channels, by the chunk's message index."""

from __future__ import annotations

import io
from collections.abc import Collection, Iterator
from pathlib import Path

from tfloom.bag.reading import mcap_records as records
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.mcap_layout import Span, decompressed, warn_of_damage, whole_records
from tfloom.bag.reading.mcap_records import RECORD_HEADER, Opcode, RecordError

__all__ = ["SparseReader"]

GAP = 1 << 15
"""Bytes between two messages that are read rather than skipped, because another read costs as much."""
AHEAD = 1 << 12
"""Bytes that are read at least from the beginning of the last message of a run."""
DENSE = 1 << 16
"""The size of a chunk that is read whole without a look at its index [bytes]."""


class SparseReader:
    """Reads the records of spans that have messages of some channels.

    Args:
        file: The open file.
        path: Its path, for warnings.
        channels: The channels.
    """

    def __init__(self, file: io.FileIO, path: Path, channels: Collection[int]) -> None:
        self._file = file
        self._path = path
        self._channels = channels

    def records(self, span: Span) -> Iterator[bytes]:
        """Yield runs of whole records that have all messages of the channels, and others.

        A damaged chunk is left out, after a warning.
        """
        # By how much there is to gain: nothing is read of a chunk without such messages, and all of it if they are
        # more than half of it; of a compressed chunk its beginning, because decompression can't start in the middle.
        runs = self._runs(span)
        if runs == []:
            return
        if runs is None or sum(end - start for start, end in runs) > span.size // 2:
            yield whole_records(self._file, self._path, span)
        elif span.compression:
            yield self._beginning(span, runs[-1][1])
        else:
            for start, end in runs:
                yield self._run(span, start, end)

    def _runs(self, span: Span) -> list[tuple[int, int]] | None:
        """Return where runs of messages begin, and where the last record of each begins; None without an index."""
        if not span.index_offsets or span.size < DENSE or not span.is_whole:
            return None
        offsets: list[int] = []
        for channel, at in span.index_offsets.items():
            if channel in self._channels:
                try:
                    offsets += self._index(channel, at)
                except RecordError as error:
                    warn_of_damage(self._path, span, f"its index: {error}", "the index isn't used")
                    return None
        # Offsets are those of the records' beginnings: where the last record of a run ends is known when it is read.
        offsets.sort()
        runs: list[tuple[int, int]] = []
        for offset in offsets:
            if runs and offset - runs[-1][1] < GAP:
                runs[-1] = runs[-1][0], offset
            else:
                runs.append((offset, offset))
        return runs

    def _index(self, channel: int, at: int) -> list[int]:
        """Return the offsets of a channel's messages in the decompressed chunk.

        Raises:
            RecordError: there is no such index at this offset.
        """
        data = read_at(self._file, at, AHEAD)
        opcode, length = records.record_header(data)
        if opcode != Opcode.MESSAGE_INDEX:
            raise RecordError(f"a record of kind {opcode} is there")
        end = RECORD_HEADER.size + length
        if end > len(data):
            data += read_at(self._file, at + len(data), end - len(data))
        of_channel, entries = records.read_message_index(data[RECORD_HEADER.size : end])
        if of_channel != channel:
            raise RecordError(f"it is of channel {of_channel}, not {channel}")
        return [offset for _, offset in entries]

    def _beginning(self, span: Span, last: int) -> bytes:
        """Return the records up to the one that begins at `last`."""
        # A guess, for the same reason as in `_run`. If the last record is longer, the whole chunk is decompressed.
        data = decompressed(self._file, self._path, span, min(span.size, last + GAP)) or b""
        end = _end(data, last)
        if end <= len(data):
            return data[:end]
        return whole_records(self._file, self._path, span)

    def _run(self, span: Span, start: int, last: int) -> bytes:
        """Return the records from one offset to the one that begins at another, of a chunk that isn't compressed."""
        if last + RECORD_HEADER.size > span.size:
            warn_of_damage(self._path, span, f"its index has a message at byte {last}")
            return b""
        # The length of the last record is in its header. A little more is read at once, in which most of these records
        # end; a second read fetches the rest of a larger one.
        size = min(last + AHEAD, span.size) - start
        data = read_at(self._file, span.offset + start, size)
        end = min(_end(data, last - start), span.size - start)
        if end > len(data):
            data += read_at(self._file, span.offset + start + len(data), end - len(data))
        return data[:end]


def _end(data: bytes, at: int) -> int:
    """Return where the record ends that begins at an offset; beyond the data if that isn't known."""
    if at + RECORD_HEADER.size > len(data):
        return len(data) + 1
    _, length = records.record_header(data[at : at + RECORD_HEADER.size])
    return at + RECORD_HEADER.size + length
