"""Bytes of a file, by offsets and sizes that the file itself states."""

from __future__ import annotations

import io
import os
import stat
from pathlib import Path

from tfloom.bag.errors import BagError
from tfloom.bag.reading.compression import MOST

__all__ = ["BLOCK", "check_is_file", "read_at"]

BLOCK = 1 << 22
"""How much is read at once of messages outside of chunks [bytes]."""
MAX_UNCHECKED_SIZE = 1 << 20
"""How much is read without a look at the file's size [bytes]."""
MAX_OFFSET = (1 << 63) - 1
"""The greatest offset that a system's files have."""


def read_at(file: io.FileIO, offset: int, size: int) -> bytes:
    """Return bytes of a file; fewer at its end, and `MOST` at most.

    Offset and size may be any numbers, because files state them.
    """
    if size > MAX_UNCHECKED_SIZE:
        size = min(size, MOST, os.fstat(file.fileno()).st_size - offset)
    if size <= 0 or not 0 <= offset <= MAX_OFFSET:
        return b""
    file.seek(offset)
    data: bytes = file.read(size) or b""
    while len(data) < size and (more := file.read(size - len(data))):
        data += more
    return data


def check_is_file(path: Path) -> None:
    """Raise BagError unless a path leads to a regular file, because opening a FIFO would wait for its writer.

    Raises:
        OSError: there is no such file.
    """
    if not stat.S_ISREG(path.stat().st_mode):
        raise BagError(
            path, "this is not a file but a folder, a FIFO, a socket or a device: copy it into a file"
        )
