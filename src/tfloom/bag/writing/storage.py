"""What writers of bags share: a file of one storage, its topics, and its settings."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple, Protocol

from tfloom._native import Chunk
from tfloom.bag.values import Topic

__all__ = ["STORAGES", "StorageFile", "StorageSettings", "open_storage_file"]

STORAGES = {"mcap": ".mcap", "sqlite3": ".db3"}
"""The storages, each with the suffix of its files."""


class StorageSettings(NamedTuple):
    """How a storage writes its files. Each storage uses some of these."""

    compression: str = ""
    """Of chunks: empty, `lz4` or `zstd`."""
    level: str = "Default"
    """Of compression: Fastest, Fast, Default, Slow or Slowest."""
    chunk_size: int = 768 * 1024
    """Size of a complete chunk [bytes]."""
    is_chunked: bool = True
    has_message_index: bool = True
    has_summary: bool = True
    has_chunk_crc: bool = False
    pragmas: tuple[str, ...] = ()
    """Of sqlite3, in addition to those of the writer."""


class StorageFile(Protocol):
    """A file that is being written."""

    @property
    def size(self) -> int:
        """Size of what is written [bytes]."""

    def write(self, chunk: Chunk) -> None:
        """Write the messages of a chunk.

        Raises:
            OSError: they can't be written; what was written before stays readable.
        """

    def close(self, metadata: str) -> None:
        """Complete the file; `metadata` is that of the bag so far, as YAML. Closing again does nothing.

        Raises:
            OSError: it can't be completed; the messages that were written stay readable.
        """


def open_storage_file(
    storage_id: str, path: Path, topics: Mapping[int, Topic], settings: StorageSettings, metadata: str
) -> StorageFile:
    """Create a file.

    Args:
        storage_id: A key of `STORAGES`.
        path: The file, which must not exist.
        topics: By channel number, from 1; the writer of the bag adds to it.
        settings: How it is written.
        metadata: Of the bag so far, as YAML.

    Raises:
        OSError: it can't be created.
    """
    if storage_id == "mcap":
        from tfloom.bag.writing.mcap_file import McapFile

        return McapFile(path, topics, settings, metadata)
    from tfloom.bag.writing.sqlite_file import SqliteFile

    return SqliteFile(path, topics, settings, metadata)
