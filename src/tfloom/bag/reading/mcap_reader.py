"""Messages and transforms of an MCAP file, and the log times of its chunks, which may declare others."""

from __future__ import annotations

import io
from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from pathlib import Path

from tfloom import _native
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import is_message_compression
from tfloom.bag.reading import mcap_records as records
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.mcap_layout import Layout, Span, decompressed, warn_of_damage, whole_records
from tfloom.bag.reading.mcap_scan import Scan
from tfloom.bag.reading.mcap_sparse import SparseReader
from tfloom.bag.reading.mcap_summary import read_layout
from tfloom.bag.reading.message_order import Found, in_order
from tfloom.bag.reading.stored_messages import StoredMessages
from tfloom.bag.values import EARLIEST, LATEST, MAY_BE_EMPTY, Definition, Progress, RawMessage, TfTopic, Topic

__all__ = ["McapFile", "with_true_times"]


class McapFile(StoredMessages):
    """A file of a recording. It is open while it is read only.

    Args:
        path: The file.
        is_message_compressed: Whether each message is compressed by itself, by zstd; None: as the file's metadata says.

    Raises:
        BagError: it is not an MCAP file, or damaged.
        OSError: it can't be read.

    Attributes:
        layout: What the file consists of.
    """

    def __init__(self, path: Path, is_message_compressed: bool | None = None) -> None:
        self.path = path
        with self._open() as file:
            self.layout = read_layout(file, path)
        self.start_ns, self.end_ns = self.layout.start_ns, self.layout.end_ns
        self.message_count = self.layout.counts.total()
        self.is_message_compressed = (
            self._says_compressed() if is_message_compressed is None else is_message_compressed
        )

    def _open(self) -> io.FileIO:
        return io.FileIO(self.path)

    @cached_property
    def topics(self) -> list[Topic]:
        """The topics; one for each name, with the type of its first channel."""
        # Several channels may have the same topic. Their messages are counted together.
        topics: dict[str, Topic] = {}
        for channel in self.layout.channels.values():
            topic = self._topic(channel)
            before = topics.get(topic.name)
            if before is not None:
                topic = before._replace(message_count=before.message_count + topic.message_count)
            topics[topic.name] = topic
        return list(topics.values())

    def _topic(self, channel: records.Channel) -> Topic:
        schema = self.layout.schemas.get(channel.schema_id)
        definition = None
        if schema and (schema.data or schema.encoding == MAY_BE_EMPTY):
            definition = Definition(schema.encoding, schema.data.decode(errors="replace"))
        return Topic(
            channel.topic,
            schema.name if schema else "",
            channel.encoding,
            channel.metadata.get("topic_type_hash", ""),
            channel.metadata.get("offered_qos_profiles", ""),
            definition,
            self.layout.counts[channel.id],
        )

    def metadata(self, name: str) -> dict[str, str] | None:
        """Return the last metadata record of a name, or None.

        Raises:
            BagError: it is damaged.
        """
        for record_name, offset in reversed(self.layout.metadata_offsets):
            if record_name == name:
                with self._open() as file:
                    return self._read_metadata(file, offset)
        return None

    def _says_compressed(self) -> bool:
        try:
            values = self.metadata(records.METADATA_NAME) or {}
        except BagError:
            return False
        return is_message_compression(values.get(records.METADATA_KEY, ""))

    def _read_metadata(self, file: io.FileIO, offset: int) -> dict[str, str]:
        try:
            opcode, length = records.record_header(read_at(file, offset, records.RECORD_HEADER.size))
            content = offset + records.RECORD_HEADER.size
            if opcode == records.Opcode.METADATA and content + length <= file.seek(0, io.SEEK_END):
                fields = records.Fields(read_at(file, content, length))
                _ = fields.text()
                return fields.texts()
        except (records.RecordError, OverflowError):
            pass
        raise BagError(self.path, "the metadata is damaged", offset)

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: the file can't be decompressed.
        """
        names = {channel.id: channel.topic for channel in self.layout.channels.values()}
        if topics is not None:
            names = {number: name for number, name in names.items() if name in topics}
        with self._open() as file:
            spans = self._chosen_spans(file, names, start_ns, end_ns)
            for log, channel, publish, data in in_order(
                spans, lambda span: self._read(file, span, names, start_ns, end_ns)
            ):
                yield RawMessage(names[channel], log, publish, self._message(data))

    def _chosen_spans(
        self, file: io.FileIO, channels: Collection[int], start_ns: int, end_ns: int
    ) -> list[Span]:
        """Return the spans that may have messages of these channels and times, by their first log time."""
        # Chunks are chosen by their times, which they only declare. Where all times are read, a wrong declaration
        # leaves nothing out, so the true times are looked up for a part of the bag only.
        if start_ns > EARLIEST or end_ns < LATEST:
            self.layout.spans = [with_true_times(file, self.path, span) for span in self._spans(file)]
        spans = [
            span
            for span in self._spans(file)
            if span.start_ns <= end_ns
            and span.end_ns >= start_ns
            and (span.channels is None or not span.channels.isdisjoint(channels))
        ]
        return sorted(spans, key=lambda span: span.start_ns)

    def _spans(self, file: io.FileIO) -> list[Span]:
        if self.layout.spans is None:  # messages are outside of chunks
            scan = Scan(file, self.path, Layout(self.layout.header))
            scan.run()
            self.layout.spans = scan.layout.spans or []
        return self.layout.spans

    def _read(
        self, file: io.FileIO, span: Span, channels: Collection[int], start_ns: int, end_ns: int
    ) -> list[Found]:
        data = whole_records(file, self.path, span)
        try:
            places = _native.list_mcap_messages(data, channels, start_ns, end_ns)
        except ValueError as error:
            warn_of_damage(self.path, span, str(error))
            return []
        return [(log, channel, publish, data[at : at + size]) for log, channel, publish, at, size in places]

    def insert_transforms(
        self,
        into: _native.TfRecords,
        topics: Mapping[str, TfTopic],
        start_ns: int,
        end_ns: int,
        progress: Progress,
    ) -> None:
        """Store the transforms of topics by name; moving ones if their log times are in [start, end].

        Only what has messages of these topics is read.

        Raises:
            BagError: the file can't be decompressed.
        """
        if self.is_message_compressed:
            super().insert_transforms(into, topics, start_ns, end_ns, progress)
            return
        declared = self.layout.channels.values()
        channels = {
            channel.id: topics[channel.topic].number for channel in declared if channel.topic in topics
        }
        static = {
            channel.id for channel in declared if channel.id in channels and topics[channel.topic].is_static
        }
        with self._open() as file:
            # A static transform holds at all times, so it is stored whenever it was published. A span may be there for
            # both reasons; it is read once, in the order of the file.
            spans = [
                *self._chosen_spans(file, channels, start_ns, end_ns),
                *self._chosen_spans(file, static, EARLIEST, LATEST),
            ]
            reader = SparseReader(file, self.path, channels)
            for _, span in sorted({span.offset: span for span in spans}.items()):
                for data in reader.records(span):
                    self._insert(into, span, data, channels, (start_ns, end_ns))
                progress(span.stored_size)

    def _insert(
        self,
        into: _native.TfRecords,
        span: Span,
        data: bytes,
        channels: Mapping[int, int],
        times: tuple[int, int],
    ) -> None:
        try:
            into.insert_mcap(data, list(channels.items()), *times)
        except ValueError as error:
            warn_of_damage(self.path, span, str(error))


def with_true_times(file: io.FileIO, path: Path, span: Span) -> Span:
    """Return a span with the times of its messages.

    A part of a bag is read by leaving out chunks of other times, and a chunk that declares wrong ones would be left
    out with its messages in silence. Its message indexes are small and tell them; without indexes it is read itself.

    Args:
        file: The open file.
        path: Its path, for warnings.
        span: A span, as the file declares it.

    Raises:
        BagError: it has no index and can't be decompressed, because the compression is unknown, or its library isn't
            installed.
    """
    if not span.are_times_declared:
        return span
    first, last = _times_of_indexes(file, span) or _times_of_messages(file, path, span)
    return span._replace(
        start_ns=min(first, span.start_ns), end_ns=max(last, span.end_ns), are_times_declared=False
    )


def _times_of_indexes(file: io.FileIO, span: Span) -> tuple[int, int] | None:
    if not span.index_length:
        return None
    try:
        count, first, last = _native.summarise_mcap_indexes(
            read_at(file, span.offset + span.stored_size, span.index_length)
        )
    except ValueError:
        return None
    return (first, last) if count else None


def _times_of_messages(file: io.FileIO, path: Path, span: Span) -> tuple[int, int]:
    data = decompressed(file, path, span) or b""
    try:
        counts, first, last, _, _ = _native.summarise_mcap(data, 0)
    except ValueError:
        counts = {}
    return (first, last) if counts else (span.start_ns, span.end_ns)
