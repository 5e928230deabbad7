"""Writers that take one message after the other."""

from __future__ import annotations

from contextlib import suppress
from enum import IntEnum
from pathlib import Path

from tfloom.bag.errors import BagError
from tfloom.bag.rosbag2_names.storage import (
    ConverterOptions,
    StorageOptions,
    TopicMetadata,
    options_error,
)
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.bag.writing.storage import STORAGES
from tfloom.bag.writing.storage_config import storage_settings

__all__ = [
    "CompressionMode",
    "CompressionOptions",
    "SequentialCompressionWriter",
    "SequentialWriter",
    "compression_mode_from_string",
    "compression_mode_to_string",
    "get_registered_compressors",
    "get_registered_serializers",
    "get_registered_writers",
    "writer_settings",
]


class CompressionMode(IntEnum):
    """Whether whole files are compressed, or each message by itself."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


class CompressionOptions:
    """How a bag that is written is compressed."""

    def __init__(
        self,
        compression_format: str = "",
        compression_mode: CompressionMode = CompressionMode.NONE,
        compression_queue_size: int = 0,
        compression_threads: int = 0,
    ) -> None:
        self.compression_format = compression_format
        self.compression_mode = compression_mode
        self.compression_queue_size = compression_queue_size
        self.compression_threads = compression_threads


def writer_settings(options: StorageOptions, mode: str = "") -> WriterSettings:
    """Return the settings of a writer.

    Raises:
        BagError: the storage or the mode is unknown, or the storage's configuration can't be used.
    """
    storage_id = options.storage_id or "mcap"
    if storage_id not in STORAGES:
        raise BagError(options.uri, f"the storage '{storage_id}' is unknown; known are {', '.join(STORAGES)}")
    if mode not in {"", "FILE", "MESSAGE"}:
        raise BagError(options.uri, f"the compression mode is none, file or message, not '{mode}'")
    return WriterSettings(
        storage_id=storage_id,
        storage=storage_settings(storage_id, options.storage_preset_profile, options.storage_config_uri),
        max_file_size=options.max_bagfile_size,
        max_file_duration_ns=options.max_bagfile_duration * 1_000_000_000,
        max_files=options.max_bag_files,
        cache_size=options.max_cache_size,
        compression_mode=mode,
        custom_data=dict(options.custom_data),
        is_snapshot=options.snapshot_mode,
        snapshot_duration_ns=options.max_cache_duration * 1_000_000_000,
    )


class SequentialWriter:
    """Writes messages into a bag, which is complete after `close`, or when the writer is freed."""

    def __init__(self) -> None:
        self._writer: BagWriter | None = None
        self._channels: dict[str, int] = {}
        self._numbers: dict[tuple[str, str], int] = {}  # by name and type, of removed topics too
        self._mode = ""

    def open(self, arg0: StorageOptions, arg1: ConverterOptions) -> None:
        """Create a bag; its folder must not exist.

        Raises:
            BagError: the folder exists or can't be written, or an option can't be used.
        """
        if (error := options_error("open", arg0, arg1)) is not None:
            raise error
        if arg1.output_serialization_format not in {"", "cdr"}:
            raise BagError(arg0.uri, f"the format is cdr, not '{arg1.output_serialization_format}'")
        self.close()
        self._writer = BagWriter(Path(arg0.uri), writer_settings(arg0, self._mode))
        self._channels = {}
        self._numbers = {}

    def create_topic(self, arg0: TopicMetadata) -> None:
        """Add a topic; one that has been added is left as it is.

        Raises:
            BagError: no bag is open, or it has as many topics as it can have.
        """
        writer = self._opened()
        if arg0.name in self._channels:
            return
        topic = arg0.to_topic()
        number = self._numbers.get((topic.name, topic.type))
        if number is None:
            number = self._numbers[topic.name, topic.type] = writer.add_topic(topic)
        else:  # it was removed
            writer.set_topic(number, topic)
        self._channels[topic.name] = number

    def remove_topic(self, arg0: TopicMetadata) -> None:
        """Remove a topic: nothing more is written on it, and without messages it isn't in the bag.

        Raises:
            BagError: no bag is open.
        """
        self._opened().remove_topic(arg0.name)
        self._channels.pop(arg0.name, None)

    def write(
        self,
        topic_name: str,
        message: bytes,
        time_stamp: int | None = None,
        send_timestamp: int | None = None,
        sequence_number: int = 0,  # files have none here
        *,
        recv_timestamp: int | None = None,
    ) -> None:
        """Add a message.

        Args:
            topic_name: A topic that was created.
            message: The serialized message.
            time_stamp: Its log time [ns since epoch].
            send_timestamp: When it was published [ns since epoch]; None: at its log time.
            sequence_number: Accepted and not used.
            recv_timestamp: The log time, by its name from Lyrical on.

        Raises:
            BagError: no bag is open, the topic was not created, or the bag can't be written.
            TypeError: there is no log time, or there are two.
        """
        given = [stamp_ns for stamp_ns in (time_stamp, recv_timestamp) if stamp_ns is not None]
        if len(given) != 1:
            raise TypeError("write() needs one log time in nanoseconds: time_stamp, or recv_timestamp")
        (log_ns,) = given
        writer = self._opened()
        channel = self._channels.get(topic_name)
        if channel is None:
            raise BagError(
                writer.folder, f"Topic '{topic_name}' has not been created yet! Call 'create_topic' first."
            )
        sent_ns = log_ns if send_timestamp is None else send_timestamp
        writer.push(channel, bytes(message), log_ns, sent_ns)

    def split_bagfile(self) -> None:
        """Complete the present file, and begin the next one.

        Raises:
            BagError: no bag is open, or it can't be written.
        """
        writer = self._opened()
        writer.queue.restart_file()
        writer.write_rest()
        writer.split()

    def take_snapshot(self) -> bool:
        """Write the messages in the cache; return False unless the bag has the snapshot mode.

        Raises:
            BagError: no bag is open, or it can't be written.
        """
        writer = self._opened()
        if writer.settings.is_snapshot:
            writer.write_rest()
        return writer.settings.is_snapshot

    def close(self) -> None:
        """Complete the bag. Closing again does nothing.

        Raises:
            BagError: it can't be written.
        """
        writer, self._writer = self._writer, None
        if writer is not None:
            writer.close()

    def __del__(self) -> None:
        with suppress(Exception):  # nobody could catch it
            self.close()

    def _opened(self) -> BagWriter:
        if self._writer is None:
            raise BagError("rosbag2_py", "no bag is open: call open() before")
        return self._writer


class SequentialCompressionWriter(SequentialWriter):
    """Writes a bag whose files or messages are compressed."""

    def __init__(self, arg0: CompressionOptions | None = None) -> None:
        super().__init__()
        options = arg0 or CompressionOptions()
        if options.compression_format not in {"", "zstd"}:
            raise ValueError(f"the compression format is zstd, not '{options.compression_format}'")
        if options.compression_mode != CompressionMode.NONE:
            self._mode = CompressionMode(options.compression_mode).name


def compression_mode_from_string(arg0: str) -> CompressionMode:
    """Return the mode of a name in any case; NONE if there is none."""
    return CompressionMode.__members__.get(arg0.upper(), CompressionMode.NONE)


def compression_mode_to_string(arg0: CompressionMode) -> str:
    """Return the name of a mode."""
    return CompressionMode(arg0).name


def get_registered_compressors() -> set[str]:
    """Return the formats of compression."""
    return {"zstd"}


def get_registered_serializers() -> set[str]:
    """Return the formats into which messages are converted: none, because all messages are CDR."""
    return set()


def get_registered_writers() -> set[str]:
    """Return the storages that are written."""
    return set(STORAGES)
