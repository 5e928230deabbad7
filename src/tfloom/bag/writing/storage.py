"""What writers of bags share: a file of one storage, its topics, and its settings."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from tfloom._native import Chunk

__all__ = ["STORAGES", "StorageFile", "StorageSettings"]

STORAGES = {"mcap": ".mcap", "sqlite3": ".db3"}
"""The storages, each with the suffix of its files."""


class StorageSettings(NamedTuple):
    """How a storage writes its files. Each storage uses some of these."""

    compression: str = ""
    """Compression of chunks, `lz4` or `zstd`; empty for none."""
    level: str = "Default"
    """Level of compression, Fastest, Fast, Default, Slow or Slowest."""
    chunk_size: int = 768 * 1024
    """Size of a complete chunk [bytes]."""
    is_chunked: bool = True
    """Whether messages are in chunks; compression needs them. MCAP's, as the next three."""
    has_message_index: bool = True
    """Whether each chunk is followed by an index of its messages."""
    has_summary: bool = True
    """Whether the file ends with a summary of schemas, channels and the places of chunks."""
    has_chunk_crc: bool = False
    """Whether each chunk has a checksum."""
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
