"""A file of a recording, opened at the first use, and decompressed before if it is compressed as a whole."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from tfloom._native import TfRecords
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import FileInformation
from tfloom.bag.reading.compression import COMPRESSED_SUFFIX, CompressionError, copy_decompressed
from tfloom.bag.reading.file_bytes import check_is_file
from tfloom.bag.values import Progress, RawMessage, Storage, TfTopic, Topic

__all__ = ["BagFile", "storage_of"]


def storage_of(path: Path, is_message_compressed: bool | None = None) -> Storage:
    """Open a file of a recording, by the end of its name: .mcap, .db3, or .bag and .bag.active of ROS 1.

    Args:
        path: The file.
        is_message_compressed: Whether each message is compressed by itself; None: as the file's metadata says.

    Raises:
        BagError: it is none of these, or damaged.
        OSError: it can't be read.
    """
    check_is_file(path)
    if path.suffix == ".mcap":
        from tfloom.bag.reading.mcap_reader import McapFile

        return McapFile(path, is_message_compressed)
    if path.suffix == ".db3":
        from tfloom.bag.reading.sqlite_reader import SqliteFile

        return SqliteFile(path, is_message_compressed)
    if path.name.endswith((".bag", ".bag.active")):
        from tfloom.bag.reading.ros1_reader import Ros1File

        return Ros1File(path)
    raise BagError(
        path,
        "a file of a recording ends in .mcap, .db3, .bag or .bag.active (of ROS 1), .mcap.zstd or .db3.zstd",
    )


class BagFile:
    """A file of a recording.

    Args:
        path: The file.
        is_message_compressed: Whether each message is compressed by itself; None: as the file's metadata says.
        information: What metadata.yaml says of the file; None if it isn't there.
    """

    def __init__(
        self,
        path: Path,
        is_message_compressed: bool | None = None,
        information: FileInformation | None = None,
    ) -> None:
        self.path = path
        self._is_message_compressed = is_message_compressed
        self._information = information
        self._storage: Storage | None = None
        self._temporary: Path | None = None

    @property
    def is_compressed(self) -> bool:
        """Whether the file is compressed as a whole."""
        return self.path.suffix == COMPRESSED_SUFFIX

    @property
    def storage(self) -> Storage:
        """The open file.

        Raises:
            BagError: it is missing, or it is not a recording, or damaged.
        """
        if self._storage is None:
            try:
                path = self._decompressed() if self.is_compressed else self.path
                self._storage = storage_of(path, self._is_message_compressed)
            except FileNotFoundError:
                raise BagError(self.path, "there is no such file, which metadata.yaml names") from None
            except OSError as error:
                raise BagError(self.path, f"the file can't be read: {error.strerror}") from None
        return self._storage

    def _decompressed(self) -> Path:
        check_is_file(self.path)
        suffix = Path(self.path.stem).suffix
        handle, name = tempfile.mkstemp(suffix, "tfloom-bag-")
        self._temporary = Path(name)
        try:
            with os.fdopen(handle, "wb") as file:
                copy_decompressed(self.path, file)
        except CompressionError as error:
            self.close()
            raise BagError(self.path, str(error)) from None
        except BaseException:
            self.close()
            raise
        return self._temporary

    def close(self) -> None:
        """Remove the decompressed file. The next use makes it again."""
        self._storage = None
        if self._temporary is not None:
            self._temporary.unlink(missing_ok=True)
            self._temporary = None

    def __del__(self) -> None:
        self.close()

    @property
    def topics(self) -> list[Topic]:
        """Its topics."""
        return self.storage.topics

    @property
    def start_ns(self) -> int:
        """The least log time [ns since epoch]; 0 without messages."""
        return self._declared.start_ns if self._declared else self.storage.start_ns

    @property
    def end_ns(self) -> int:
        """The greatest log time [ns since epoch]; 0 without messages."""
        if self._declared:
            return self._declared.start_ns + self._declared.duration_ns
        return self.storage.end_ns

    @property
    def message_count(self) -> int:
        """Number of messages."""
        return self._declared.message_count if self._declared else self.storage.message_count

    @property
    def _declared(self) -> FileInformation | None:
        """What metadata.yaml says, if the file would have to be decompressed to find it."""
        return self._information if self.is_compressed and self._storage is None else None

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times."""
        was_open = self._storage is not None
        yield from self.storage.messages(topics, start_ns, end_ns)
        if self.is_compressed and not was_open:
            self.close()

    def insert_transforms(
        self,
        into: TfRecords,
        topics: Mapping[str, TfTopic],
        start_ns: int,
        end_ns: int,
        progress: Progress,
    ) -> None:
        """Store the transforms of topics by name; moving ones if their log times are in [start, end]."""
        was_open = self._storage is not None
        self.storage.insert_transforms(into, topics, start_ns, end_ns, progress)
        if self.is_compressed and not was_open:
            self.close()
