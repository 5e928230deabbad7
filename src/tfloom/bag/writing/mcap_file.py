"""A file in the MCAP format, written chunk by chunk, so that what is written stays readable."""

from __future__ import annotations

import io
import os
import struct
import zlib
from contextlib import suppress
from pathlib import Path

from tfloom import __version__
from tfloom._native import Chunk
from tfloom.bag.reading.mcap_records import MAGIC, METADATA_KEY, METADATA_NAME, Opcode
from tfloom.bag.writing import mcap_records as records
from tfloom.bag.writing.mcap_records import ChunkPlace, McapChannel, MetadataPlace
from tfloom.bag.writing.storage import StorageSettings, TopicTable

__all__ = ["McapFile"]


class McapFile:
    """An MCAP file that is being written; see `StorageFile`.

    Each topic has a channel and each type a schema, which are written before the first chunk that needs them, in it.
    """

    def __init__(self, path: Path, topics: TopicTable, settings: StorageSettings, metadata: str) -> None:
        self._topics = topics
        self._settings = settings
        self._schemas: dict[str, int] = {}
        self._written_schemas: set[int] = set()
        self._written_channels: set[int] = set()
        self._counts: dict[int, int] = {}
        self._chunks: list[ChunkPlace] = []
        self._metadata: list[MetadataPlace] = []
        self._times: tuple[int, int] | None = None
        self._size = 0
        self._file: io.FileIO | None = io.FileIO(path, "x")
        try:
            self._append(MAGIC + records.header("ros2", f"tfloom {__version__}"))
            self._write_metadata(metadata)
        except BaseException:
            self._file.close()
            raise

    @property
    def size(self) -> int:
        """Size of what is written [bytes]."""
        return self._size

    def write(self, chunk: Chunk) -> None:
        """Write the messages of a chunk."""
        counts = chunk.counts()
        new = [number for number, _ in counts if number not in self._written_channels]
        prefix = self._definitions(new)
        if self._settings.is_chunked:
            self._write_chunk(chunk, prefix)
        else:
            self._append(prefix, chunk.records)
        # Only now that the chunk is in the file: a failed write has taken its definitions back with it, and the next
        # try must write them again.
        self._written_channels.update(new)
        self._written_schemas.update(self._schema(number) for number in new)
        for number, count in counts:
            self._counts[number] = self._counts.get(number, 0) + count
        first, last = self._times or (chunk.start_ns, chunk.end_ns)
        self._times = (min(first, chunk.start_ns), max(last, chunk.end_ns))

    def close(self, metadata: str) -> None:
        """Write the metadata and the summary, and close the file."""
        file = self._file
        if file is None:
            return
        try:
            self._write_metadata(metadata)
            # The summary tells its own offsets in the file, so the record before it must be made first. Both are one
            # append: the file ends in a whole summary, or after its last whole record, and is read by a walk then.
            end = records.record(Opcode.DATA_END, struct.pack("<I", 0))
            self._append(end + self._summary(self._size + len(end)) + MAGIC)
        finally:
            self._file = None
            file.close()

    def _write_chunk(self, chunk: Chunk, prefix: bytes) -> None:
        parts = [prefix, chunk.records]
        # Messages without compression go from the queue's memory into the file as they are. The CRC goes on from that
        # of the definitions, so that the two needn't be joined for it.
        size = sum(map(len, parts))
        crc = zlib.crc32(parts[1], zlib.crc32(prefix)) if self._settings.has_chunk_crc else 0
        compression = self._settings.compression
        if compression:
            parts = [_compressed(b"".join(parts), compression, self._settings.level)]
        stored_size = sum(map(len, parts))
        head = records.chunk_head(chunk.start_ns, chunk.end_ns, (size, stored_size), crc, compression)
        length = len(head) + stored_size
        # The message indexes follow the chunk, and the summary says where they are, so their offsets are counted from
        # the chunk's place before anything is written. One append keeps chunk and indexes together.
        offset = self._size
        index_offsets: dict[int, int] = {}
        indexes = b""
        if self._settings.has_message_index:
            for number, _ in chunk.counts():
                index_offsets[number] = offset + length + len(indexes)
                indexes += records.message_index(number, chunk.index(number, len(prefix)))
        self._append(head, *parts, indexes)
        times = (chunk.start_ns, chunk.end_ns)
        place = ChunkPlace(
            *times, offset, length, index_offsets, len(indexes), compression, stored_size, size
        )
        self._chunks.append(place)

    def _write_metadata(self, metadata: str) -> None:
        record = records.metadata(METADATA_NAME, {METADATA_KEY: metadata})
        place = MetadataPlace(self._size, len(record), METADATA_NAME)
        self._append(record)
        self._metadata.append(place)

    def _append(self, *parts: bytes) -> None:
        """Append bytes; if not all can be written, leave the file as it was.

        The parts are not joined, because copying large messages takes as long as writing them.
        """
        if self._file is None:
            raise ValueError("the file is closed")
        try:
            for part in parts:
                # The file has no buffer, and a system call may write a part only, for instance what the disk has room
                # for. The rest is tried until all is written or an error tells why not.
                left = memoryview(part)
                while left:
                    left = left[self._file.write(left) or 0 :]
        except BaseException:
            # What went into the file is cut off, so that it ends in a whole record, and the next try begins there.
            # `_size` still has the value from before, because it is counted at the end.
            with suppress(OSError):
                self._file.truncate(self._size)
                self._file.seek(self._size, os.SEEK_SET)
            raise
        self._size += sum(map(len, parts))

    def _schema(self, number: int) -> int:
        """Return the number of the schema of a channel."""
        return self._schemas.setdefault(self._topics[number].type, len(self._schemas) + 1)

    def _definitions(self, numbers: list[int]) -> bytes:
        """Return the records of channels, each after that of its schema, where that one is not yet written."""
        parts = []
        # Two new channels may share a schema. Which ones are in the file is noted by `write`, after it has succeeded.
        defined = set(self._written_schemas)
        for number in numbers:
            if (schema := self._schema(number)) not in defined:
                defined.add(schema)
                parts.append(self._schema_record(number))
            parts.append(self._channel_record(number))
        return b"".join(parts)

    def _schema_record(self, number: int) -> bytes:
        topic = self._topics[number]
        definition = topic.definition
        encoding, text = ("", "") if definition is None else definition
        return records.schema(self._schema(number), topic.type, encoding, text)

    def _channel_record(self, number: int) -> bytes:
        topic = self._topics[number]
        values = {"offered_qos_profiles": topic.offered_qos, "topic_type_hash": topic.type_hash}
        return records.channel(
            McapChannel(number, self._schema(number), topic.name, topic.serialization_format, values)
        )

    def _summary(self, start: int) -> bytes:
        """Return what is between the data and the last magic number, if it begins at `start`."""
        groups = self._summary_groups() if self._settings.has_summary else []
        content = b""
        offsets = []
        # Records of one kind stand together, and a summary offset for each kind lets a reader go to it at once.
        for opcode, group in groups:
            if group:
                offsets.append((opcode, start + len(content), len(group)))
                content += group
        offset_start = start + len(content) if offsets else 0
        content += records.summary_offsets(offsets)
        # The CRC covers the whole summary and the footer up to the CRC itself. An offset of 0 says that there is none.
        covered = content + records.footer_before_crc(start if offsets else 0, offset_start)
        return covered + struct.pack("<I", zlib.crc32(covered))

    def _summary_groups(self) -> list[tuple[int, bytes]]:
        numbers = list(self._topics.present())  # topics may be added meanwhile
        by_schema = {self._schema(number): number for number in numbers}
        schemas = [self._schema_record(by_schema[schema]) for schema in sorted(by_schema)]
        counts = {number: self._counts.get(number, 0) for number in numbers}
        statistics = records.statistics(
            counts,
            self._times or (0, 0),
            schemas=len(schemas),
            metadata=len(self._metadata),
            chunks=len(self._chunks),
        )
        return [
            (Opcode.SCHEMA, b"".join(schemas)),
            (Opcode.CHANNEL, b"".join(self._channel_record(number) for number in numbers)),
            (Opcode.STATISTICS, statistics),
            (Opcode.CHUNK_INDEX, b"".join(records.chunk_index(place) for place in self._chunks)),
            (Opcode.METADATA_INDEX, b"".join(records.metadata_index(place) for place in self._metadata)),
        ]


def _compressed(content: bytes, compression: str, level: str) -> bytes:
    from tfloom.bag.writing.compression import compress

    return compress(content, compression, level)
