"""Files of each storage, created for writing."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tfloom.bag.values import Topic
from tfloom.bag.writing.storage import StorageFile, StorageSettings

__all__ = ["open_storage_file"]


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
