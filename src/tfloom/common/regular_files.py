"""Files whose names come from outside: neither opening nor reading one waits, or takes more memory than a limit."""

from __future__ import annotations

import errno
import io
import os
import stat
from pathlib import Path

__all__ = ["open_regular", "read_at_most"]


def open_regular(path: Path) -> io.FileIO:
    """Open a file to read it. Its name may come from outside, and be that of a pipe or a device.

    Raises:
        OSError: it can't be opened, or is not a regular file.
        ValueError: it is not a name.
    """
    file = open(path, "rb", buffering=0, opener=_open_without_waiting)  # noqa: SIM115  # the caller closes it
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(errno.EINVAL, "it is not a regular file, but a folder, a pipe or a device", str(path))
    return file


def _open_without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0))


def read_at_most(file: io.FileIO, most: int) -> bytes | None:
    """Return the bytes of a file, whatever size it tells; None if there are more than `most`.

    Raises:
        OSError: it can't be read.
    """
    parts: list[bytes] = []
    left = most + 1
    while left and (part := file.read(min(left, 2**20))):
        parts.append(part)
        left -= len(part)
    return b"".join(parts) if left else None
