"""A bag that is written: a folder with one file or several, and metadata.yaml."""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from tfloom._native import Chunk, ChunkQueue, ChunkSink
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import METADATA_FILE, FileInformation, Metadata
from tfloom.bag.reading.compression import CompressionError, lz4_frame, zstd
from tfloom.bag.values import Topic
from tfloom.bag.writing.metadata_text import (
    METADATA_VERSION,
    NO_TIME_NS,
    metadata_file_text,
    metadata_text,
)
from tfloom.bag.writing.repeated import UNLIMITED, RepeatedMessages, chunk_of, later_part
from tfloom.bag.writing.storage import STORAGES, StorageFile, StorageSettings, TopicTable
from tfloom.common.files import write_file
from tfloom.ros_imports import ros_distro

__all__ = ["TIME_FORMAT", "BagWriter", "State", "WriterSettings", "file_name", "open_storage_file"]


def open_storage_file(
    storage_id: str, path: Path, topics: TopicTable, settings: StorageSettings, metadata: str
) -> StorageFile:
    """Create a file.

    Args:
        storage_id: A key of `STORAGES`.
        path: The file, which must not exist.
        topics: By channel number; the writer of the bag adds to it.
        settings: How it is written.
        metadata: Of the bag so far, as YAML.

    Raises:
        OSError: it can't be created.
    """
    try:
        if storage_id == "mcap":
            from tfloom.bag.writing.mcap_file import McapFile

            return McapFile(path, topics, settings, metadata)
        from tfloom.bag.writing.sqlite_file import SqliteFile

        return SqliteFile(path, topics, settings, metadata)
    except FileExistsError:  # not ours
        raise
    except (
        BaseException
    ):  # without its beginning it is not a file of the storage, and in the way of another try
        for suffix in ("", "-wal", "-shm"):
            path.with_name(path.name + suffix).unlink(missing_ok=True)
        raise


DEFAULT_CACHE_SIZE = 100 * 1024 * 1024
"""Of each of the two buffers [bytes]."""
TIME_FORMAT = "%Y_%m_%d-%H_%M_%S"
"""Of the local time in the names of bags."""


class WriterSettings(NamedTuple):
    """How a bag is written."""

    storage_id: str = "mcap"
    """`mcap` or `sqlite3`."""
    storage: StorageSettings = StorageSettings()
    """How its files are written."""
    max_file_size: int = 0
    """A file of at least this size is the last one before the next [bytes]; 0 means no limit."""
    max_file_duration_ns: int = 0
    """A message later than this after a file's first begins the next file; 0 means no limit."""
    max_files: int = 0
    """When one more file begins, the oldest is deleted; 0 means no limit."""
    cache_size: int = DEFAULT_CACHE_SIZE
    """Half of the size of messages that may wait to be written [bytes]; 0 is `DEFAULT_CACHE_SIZE`."""
    compression_mode: str = ""
    """Empty, `FILE` or `MESSAGE`."""
    custom_data: Mapping[str, str] = {}
    """Texts for metadata.yaml, by name."""
    is_snapshot: bool = False
    """Whether messages wait, the oldest discarded in a full cache, until `write_present`."""
    snapshot_duration_ns: int = 0
    """How much older than its last message a snapshot's others may be; 0 is no limit."""


class State(Enum):
    """What a writer does with a chunk."""

    OPEN = "open"
    """It is written."""
    FAILED = "failed"
    """It is refused, because one before could not be written; `close` tries once more to write what is waiting."""
    CLOSED = "closed"
    """It is refused."""


class BagWriter:
    """Writes a bag. Any thread may push into `queue` and add topics; one thread calls the other methods.

    After a write that failed, nothing more is written until `close`, so that no gap is left in silence.

    Args:
        folder: The bag's folder, which must not exist.
        settings: How it is written.
        on_split: Called with the paths of the completed file and of the next one.

    Raises:
        BagError: the folder exists, or can't be written, a limit is negative, or a compression's library isn't
            installed.
    """

    def __init__(
        self,
        folder: Path,
        settings: WriterSettings | None = None,
        on_split: Callable[[Path, Path], None] | None = None,
    ) -> None:
        self.folder = folder
        self.settings = settings or WriterSettings()
        limits = (
            *(self.settings.max_file_size, self.settings.max_file_duration_ns),
            *(self.settings.max_files, self.settings.cache_size, self.settings.snapshot_duration_ns),
        )
        if min(limits) < 0:
            raise BagError(
                folder,
                "the sizes, the duration and the number that limit its files and cache can't be negative",
            )
        check_compression(folder, self.settings)
        self._on_split = on_split
        self.queue = make_queue(self.settings)
        self._repeated = RepeatedMessages()
        self._apart: dict[int, ChunkQueue] = {}
        """In snapshot mode, the queues of repeated channels, whose last messages the others must not displace."""
        self._is_paused = False
        self._simulated_ns: int | None = None
        self.state = State.OPEN
        self._topics = TopicTable()
        self._file_counts: list[Counter[int]] = []
        """Numbers of messages by channel, of each of `_files`."""
        self._opened_count = 0
        self._files: list[FileInformation] = []
        self._paths: list[str] = []
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            raise BagError(folder, "it exists already; choose another folder") from None
        except OSError as error:
            raise BagError(folder, f"it can't be created: {error.strerror}") from None
        self._unwritten: list[Chunk] = []  # taken from the queue, and not yet in a file
        self._file: StorageFile | None = None
        try:
            self._file = self._open_file()
        except BaseException:
            with suppress(OSError):
                folder.rmdir()
            raise

    @property
    def file_path(self) -> Path:
        """The file that is being written, or was the last one."""
        return self.folder / self._files[-1].path

    @property
    def message_count(self) -> int:
        """Number of messages that are written."""
        return self._counts().total()

    def _counts(self) -> Counter[int]:
        """Return the numbers of messages by channel, of all files that are kept."""
        return sum(self._file_counts, Counter())

    def add_topic(self, topic: Topic) -> int:
        """Add a topic, and return the number of its channel, from 1.

        Raises:
            BagError: there are as many as a bag can have.
        """
        try:
            return self._topics.add(topic)
        except ValueError as error:
            raise BagError(self.folder, f"'{topic.name}' can't be added: {error}") from None

    def set_topic(self, number: int, topic: Topic) -> None:
        """Replace what is known of a topic; files that already have it keep what they have, up to their summary."""
        self._topics.replace(number, topic)

    def remove_topic(self, name: str) -> None:
        """Leave a topic out of the bag, unless it has messages, also such that are still waiting."""
        self._topics.remove(name)
        self._topics.restore(list(self._counts()))

    def repeat(self, number: int, depth: int) -> None:
        """Begin each further file, and each snapshot, with the last messages of a channel; before its `sink`.

        Args:
            number: The channel's.
            depth: How many messages, above 0.
        """
        self._repeated.add(number, depth)
        if self.settings.is_snapshot:
            queue = ChunkQueue(1, min(self.settings.cache_size or DEFAULT_CACHE_SIZE, UNLIMITED), ring=True)
            queue.set_paused(self._is_paused)
            queue.set_simulated_time(self._simulated_ns)
            self._apart[number] = queue

    def sink(self, number: int) -> ChunkSink:
        """Return a sink for the samples of a channel."""
        return self._apart.get(number, self.queue).sink(number)

    def set_paused(self, is_paused: bool) -> None:
        """Set whether messages are discarded."""
        self._is_paused = is_paused
        for queue in self._queues():
            queue.set_paused(is_paused)

    def set_simulated_time(self, now_ns: int | None) -> None:
        """Set the log time of samples [ns since epoch]; 0: unknown, none is stored; None: their time of receipt."""
        self._simulated_ns = now_ns
        for queue in self._queues():
            queue.set_simulated_time(now_ns)

    def close_queues(self) -> None:
        """Take no more messages."""
        for queue in self._queues():
            queue.close()

    def _queues(self) -> list[ChunkQueue]:
        return [self.queue, *self._apart.values()]

    def push(self, channel: int, data: bytes, log_time_ns: int, publish_time_ns: int) -> None:
        """Add a message, and write the chunks that are complete.

        Raises:
            BagError: they can't be written; `close` tries once more. After that, no message is added.
        """
        self._check_open()
        self.queue.push(channel, data, log_time_ns, publish_time_ns)
        if self.queue.has_chunk and not self.settings.is_snapshot:
            self.write_complete()

    def write_complete(self) -> None:
        """Write the chunks that are complete.

        Raises:
            BagError: they can't be written; what was written before stays readable.
        """
        while self.queue.has_chunk:
            chunk = self.queue.take(0)
            if chunk is not None:
                self.write_chunk(chunk)

    def write_present(self) -> None:
        """Write the messages that are waiting now, and not all of those that arrive meanwhile.

        Raises:
            BagError: they can't be written; what was written before stays readable.
        """
        self.queue.seal()
        if self.settings.is_snapshot:
            self._write_snapshot()
        else:
            self.write_complete()

    def _write_snapshot(self) -> None:
        chunks = _taken(self.queue)
        apart = [
            message
            for queue in self._apart.values()
            for chunk in _taken(queue)
            for message in chunk.messages()
        ]
        apart.sort(key=lambda message: message[1])
        newest_ns = max([*(chunk.end_ns for chunk in chunks), *(message[1] for message in apart)], default=0)
        start_ns = min((chunk.start_ns for chunk in chunks), default=0)
        if self.settings.snapshot_duration_ns:
            start_ns = max(start_ns, newest_ns - self.settings.snapshot_duration_ns)
        # What is older than all others would be far before the snapshot's beginning: only its last messages are wanted.
        self._repeated.note_messages(message for message in apart if message[1] < start_ns)
        recent = [message for message in apart if message[1] >= start_ns]
        first = self._repeated.chunk_at(start_ns or newest_ns)
        self._repeated.note_messages(recent)
        parts = [first, *(later_part(chunk, start_ns) for chunk in chunks), chunk_of(recent)]
        chunks = [chunk for chunk in parts if chunk is not None]
        # All of them are held until they are in a file: they are in the queue no more.
        self._unwritten += chunks
        for chunk in chunks:
            self.write_chunk(chunk)

    def write_rest(self) -> None:
        """Write all messages that are waiting; the queue must not grow meanwhile.

        Raises:
            BagError: they can't be written; what was written before stays readable.
        """
        while (chunk := self.queue.take(0)) is not None:
            self.write_chunk(chunk)

    def write_chunk(self, chunk: Chunk) -> None:
        """Write one chunk, into the next file if this one is complete.

        Raises:
            BagError: it can't be written; what was written before stays readable.
        """
        # The queue has forgotten a chunk that was taken, so the writer holds it until it is in a file, also while it
        # refuses to write. `close` passes what is held to this method again: such a chunk must not be held twice.
        if chunk not in self._unwritten:
            self._unwritten.append(chunk)
        self._check_open()
        # A split for another reason may have begun a file that has no message yet: this chunk then belongs to it.
        if chunk.starts_file and self._files[-1].message_count:
            self.split()
        with self._failing():
            if self._file is None:  # the one before could be completed, but the next one not opened
                self._file = self._open_file()
            if not self.settings.is_snapshot and not self._files[-1].message_count and self._opened_count > 1:
                self._write_repeated(self._file, chunk.start_ns)
            self._file.write(self._stored(chunk))
        self._unwritten.remove(chunk)
        self._count(chunk)
        if not self.settings.is_snapshot:
            self._repeated.note(chunk)
        # The queue ends files by their duration, and knows nothing of their size, so it must be told that this one
        # ends here: the duration of the next file is counted from the next message.
        if 0 < self.settings.max_file_size <= self._file.size:
            self.queue.restart_file()
            self.split()

    def _write_repeated(self, file: StorageFile, stamp_ns: int) -> None:
        if (chunk := self._repeated.chunk_at(stamp_ns)) is not None:
            file.write(self._stored(chunk))
            self._count(chunk)

    def split(self) -> None:
        """Complete the file and begin the next one.

        Raises:
            BagError: one of them can't be written; what was written before stays readable.
        """
        self._check_open()
        with self._failing():
            closed = self._close_file()
            self._file = self._open_file()
        self._delete_oldest()
        if self._on_split is not None:
            self._on_split(closed, self.file_path)

    def _delete_oldest(self) -> None:
        """Delete the oldest files while there are more than may be; one that can't be deleted stays in the bag."""
        while 0 < self.settings.max_files < len(self._files):
            oldest = self.folder / self._paths[0]
            try:
                oldest.unlink(missing_ok=True)
            except OSError as error:
                from tfloom.node.log.logging import (
                    get_logger,  # which programs that write a bag mostly don't need
                )

                get_logger("rosbag2_cpp").warning(
                    f"The oldest file {oldest} can't be deleted: {error.strerror}"
                )
                return
            del self._files[0], self._paths[0], self._file_counts[0]

    def close(self) -> None:
        """Write what is waiting, complete the file, and write metadata.yaml. Closing again does nothing.

        Messages that wait for a snapshot are discarded. After a failure, what is waiting is tried once more.

        Raises:
            BagError: one of them can't be written; what was written before stays readable.
        """
        if self.state is State.CLOSED:
            return
        self.queue.close()
        # Any write that failed is tried once more here, because the disk may have room again. A failure before
        # `close` has set the state, which would refuse the chunks that are held.
        self.state = State.OPEN
        try:
            self._write_waiting()
        except BagError:
            # A failure in `close` itself gets one more try, too. It is raised even if that succeeds.
            self.state = State.OPEN
            self._write_waiting()
            raise
        finally:
            # Each step is done whether or not the one before failed: a file that lacks its last messages still gets
            # its summary, and a bag whose last file can't be completed still gets its metadata.yaml.
            try:
                with self._failing():
                    self._close_file()
            finally:
                try:
                    with self._failing():
                        write_file(self.folder / METADATA_FILE, metadata_file_text(self.info()))
                finally:
                    self.state = State.CLOSED

    def _write_waiting(self) -> None:
        """Write all that was pushed, first the chunks that were refused."""
        while self._unwritten:
            self.write_chunk(self._unwritten[0])
        if not self.settings.is_snapshot:
            self.write_rest()

    def _check_open(self) -> None:
        if self.state is State.CLOSED:
            raise BagError(self.folder, "it is closed, and nothing more can be written")
        if self.state is State.FAILED:
            raise BagError(
                self.folder,
                "a write has failed, and nothing more is written; close it, and record into another",
            )

    @contextmanager
    def _failing(self) -> Iterator[None]:
        """Raise what is raised in the block as BagError, and write nothing more until the bag is closed."""
        try:
            yield
        except BagError:
            self.state = State.FAILED
            raise
        except Exception as error:
            self.state = State.FAILED
            raise self._failure(error) from error
        except BaseException:  # Ctrl-C in the middle of a write
            self.state = State.FAILED
            raise

    def info(self) -> Metadata:
        """Return the metadata of what is written."""
        used = [file for file in self._files if file.message_count]
        start_ns = min((file.start_ns for file in used), default=NO_TIME_NS)
        end_ns = max((file.start_ns + file.duration_ns for file in used), default=start_ns)
        counts = self._counts()
        topics = [
            topic._replace(message_count=counts[number]) for number, topic in self._topics.present().items()
        ]
        mode = self.settings.compression_mode
        return Metadata(
            version=METADATA_VERSION,
            storage_identifier=self.settings.storage_id,
            duration_ns=end_ns - start_ns,
            start_ns=start_ns,
            message_count=sum(topic.message_count for topic in topics),
            topics=sorted(topics, key=lambda topic: topic.name),
            compression_format="zstd" if mode else "",
            compression_mode=mode,
            relative_file_paths=list(self._paths),
            files=list(self._files),
            custom_data=dict(self.settings.custom_data),
            ros_distro=ros_distro.ROS_DISTRO,
        )

    def _open_file(self) -> StorageFile:
        storage_id = self.settings.storage_id
        name = file_name(self.folder, self._opened_count) + STORAGES[storage_id]
        path = self.folder / name
        info = FileInformation(name, NO_TIME_NS, 0, 0)
        # A file begins as the only one, without messages. It has the compression, because that is all that says of a
        # file that its messages are compressed if its recorder is killed.
        empty = self.info()._replace(duration_ns=0, start_ns=NO_TIME_NS, message_count=0, topics=[])
        first = empty._replace(relative_file_paths=[name], files=[info])
        try:
            file = open_storage_file(
                storage_id, path, self._topics, self.settings.storage, metadata_text(first)
            )
        except OSError as error:
            raise self._failure(error, path) from error
        # Only now that the file exists: the next try after a failure must use the same name, and metadata.yaml must
        # name no file that isn't there.
        self._opened_count += 1
        self._files.append(info)
        self._file_counts.append(Counter())
        self._paths.append(name)
        return file

    def _close_file(self) -> Path:
        """Complete the file, compress it if that is wanted, and return its path."""
        path = self.file_path
        file, self._file = self._file, None  # whatever happens, nothing more is written into it
        if file is None:
            return path
        file.close(metadata_text(self.info()))
        if self.settings.compression_mode == "FILE":
            from tfloom.bag.writing.compression import compress_file

            try:
                path = compress_file(path)
            except CompressionError as error:
                raise BagError(path, f"it is written, but can't be compressed: {error}") from error
            # `_files` keeps the name without the compression's suffix, as rosbag2 writes it into metadata.yaml.
            self._paths[-1] = path.name
        return path

    def _count(self, chunk: Chunk) -> None:
        # A topic that was removed while its messages were waiting is in the bag all the same.
        self._topics.restore([number for number, _ in chunk.counts()])
        for number, count in chunk.counts():
            self._file_counts[-1][number] += count
        # Chunks may overlap in time, and come in any order of their stamps, so both ends of the file may move.
        last = self._files[-1]
        first_ns, end_ns = chunk.start_ns, chunk.end_ns
        if last.message_count:
            first_ns, end_ns = min(first_ns, last.start_ns), max(end_ns, last.start_ns + last.duration_ns)
        self._files[-1] = FileInformation(
            last.path, first_ns, end_ns - first_ns, last.message_count + chunk.message_count
        )

    def _stored(self, chunk: Chunk) -> Chunk:
        """Return the chunk as the file has it: with each message compressed if that is the mode."""
        if self.settings.compression_mode != "MESSAGE":
            return chunk
        from tfloom.bag.writing.compression import compressor

        compress = compressor().compress
        compressed = chunk_of(
            (number, log_ns, publish_ns, compress(data))
            for number, log_ns, publish_ns, data in chunk.messages()
        )
        return compressed or chunk

    def _failure(self, error: Exception, path: Path | None = None) -> BagError:
        reason = isinstance(error, OSError) and error.strerror
        return BagError(
            path or self.file_path,
            f"it can't be written: {reason or f'{type(error).__name__}: {error}'}. What was recorded before is kept; "
            f"if metadata.yaml is missing, `ros2 bag reindex {self.folder}` writes it.",
        )


def _taken(queue: ChunkQueue) -> list[Chunk]:
    """Return the chunks that wait in a queue, and remove them; the unfinished one must be completed before."""
    chunks = []
    while queue.has_chunk and (chunk := queue.take(0)) is not None:
        chunks.append(chunk)
    return chunks


def check_compression(folder: Path, settings: WriterSettings) -> None:
    """Raise BagError unless the library of the compression is installed."""
    methods = {"zstd" if settings.compression_mode else "", settings.storage.compression}
    try:
        if "zstd" in methods:
            zstd()
        if "lz4" in methods:
            lz4_frame()
    except CompressionError as error:
        raise BagError(folder, str(error)) from None


def make_queue(settings: WriterSettings) -> ChunkQueue:
    """Return the queue of a recording with these settings."""
    chunk_size = settings.storage.chunk_size
    if settings.max_file_size:
        chunk_size = min(chunk_size, settings.max_file_size)
    cache_size = min(settings.cache_size or DEFAULT_CACHE_SIZE, UNLIMITED)
    duration_ns = min(settings.max_file_duration_ns, UNLIMITED)
    if settings.is_snapshot:
        return ChunkQueue(max(1, min(chunk_size, cache_size // 8)), cache_size, duration_ns, ring=True)
    return ChunkQueue(min(chunk_size, cache_size), 2 * cache_size, duration_ns)


def file_name(folder: Path, number: int) -> str:
    """Return the name of a bag's file without its ending, by the distribution that is followed.

    It is `folder_0`; from Lyrical on, `0_folder_2026_05_23-10_00_00`, where the folder's own time is left out.

    Args:
        folder: The bag's folder.
        number: How many files of the bag are before it.
    """
    name = folder.resolve().name
    if not ros_distro.BAG_FILES_HAVE_TIMES:
        return f"{name}_{number}"
    prefix = re.sub(r"_?\d{4}(_\d\d){2}-\d\d(_\d\d){2}$", "", name)
    return "_".join(filter(None, (str(number), prefix, time.strftime(TIME_FORMAT))))
