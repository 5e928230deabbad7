"""The file of a ROS 1 bag for the library rosbags, with bounds on what its fields make the library read."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tfloom.bag.reading.file_bytes import MOST_UNCHECKED

__all__ = ["opened"]

SLACK = 1 << 20
"""How much more than the file is read of its index, where records are looked at twice [bytes]."""


class _Source:
    """Stands for the path that a reader of rosbags opens."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self.file: _BoundedFile | None = None

    def __str__(self) -> str:
        return str(self._path)

    def open(self, _mode: str) -> _BoundedFile:
        """Open the file."""
        self.file = _BoundedFile(io.FileIO(self._path))
        return self.file


class _BoundedFile(io.BufferedReader):
    """A file that allocates no more than it has, and whose index is read once."""

    def __init__(self, raw: io.FileIO) -> None:
        super().__init__(raw)
        self._size = os.fstat(raw.fileno()).st_size
        self.left: int | None = self._size + SLACK
        """How many more bytes may be read; None: no limit."""

    def read(self, size: int | None = -1, /) -> bytes:
        if size is not None and size > MOST_UNCHECKED:
            size = min(size, max(0, self._size - self.tell()))  # Python allocates before it reads
        data = super().read(size)
        if self.left is not None:
            self.left -= len(data)
            if self.left < 0:
                raise ValueError("its index names the same records again and again")
        return data


@contextmanager
def opened(reader: Any, path: Path) -> Iterator[Any]:
    """Open a reader of rosbags for the block.

    Raises:
        ValueError: its index has more than the file.
    """
    source = _Source(path)
    reader.path = source
    with reader:
        if source.file is not None:
            source.file.left = None  # a chunk may be read several times
        yield reader
