"""Files that appear complete or not at all, and files whose names come from outside.

A file is written beside its place, then renamed to it. A full disk, an error or a signal leaves the previous file as it
was. A symbolic link stays, and its target is replaced. A new file has the permissions of the previous one, else those
of the umask. What isn't a regular file, as /dev/stdout or a named pipe, is written directly, and so is a file in a
folder that may not be written.

Of a file whose name comes from outside, neither opening nor reading waits, or takes more memory than a limit.
"""

from __future__ import annotations

import errno
import io
import os
import stat
from contextlib import suppress
from pathlib import Path

__all__ = ["Replacement", "open_regular", "read_at_most", "write_file"]

_DEVICES = ("/dev/", "/proc/")


def write_file(path: str | os.PathLike[str], data: bytes | bytearray | memoryview | str) -> None:
    """Write a file, whole.

    Args:
        path: The file; its folder must exist.
        data: Its content; a str is written as UTF-8.

    Raises:
        OSError: it can't be written; its `filename` is `path`.
    """
    content = data.encode() if isinstance(data, str) else data
    replacement = Replacement(path)
    try:
        with replacement.partial.open("wb") as file:
            file.write(content)
        replacement.commit()
    except BaseException as error:
        replacement.discard()
        if isinstance(error, OSError):
            _name(error, path)
        raise


class Replacement:
    """A new file for a path, with a temporary name in the same folder until it is complete.

    Args:
        path: The file to create or to replace; its folder must exist.

    Raises:
        OSError: it can't be written; its `filename` is `path`.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._path = Path(path)
        self._mode: int | None = None
        try:
            self._target = self._path.resolve()
            self._temporary = self._make()
        except RuntimeError:  # of `resolve`, up to Python 3.12
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), os.fspath(path)) from None
        except OSError as error:
            _name(error, path)
            raise

    @property
    def partial(self) -> Path:
        """The file to write: the temporary one, or the path itself where it is written directly."""
        return self._temporary or self._path

    def _make(self) -> Path | None:
        """Create the temporary file and return its name; None if the path is written directly."""
        with suppress(FileNotFoundError):
            status = self._path.stat()
            if not stat.S_ISREG(status.st_mode) or str(self._path.absolute()).startswith(_DEVICES):
                return None
            if not os.access(self._path, os.W_OK):
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
            self._mode = stat.S_IMODE(status.st_mode)
        name = f".{self._target.stem[:32]}.{os.urandom(4).hex()}{self._target.suffix[:32]}"
        temporary = self._target.with_name(name)
        try:
            temporary.touch(exist_ok=False)
        except PermissionError:
            if self._mode is None:
                raise
            return None
        return temporary

    def commit(self) -> None:
        """Put the new file in the place of the path.

        Raises:
            OSError: that fails; the path is as before.
        """
        if self._temporary is None:
            return
        with self._temporary.open("r+b") as file:
            os.fsync(file.fileno())
        if self._mode is not None:
            self._temporary.chmod(self._mode)
        self._temporary.replace(self._target)

    def discard(self) -> None:
        """Remove the new file, unless it was committed or written directly; leave it where that can't be done."""
        if self._temporary is not None:
            with suppress(OSError):  # the caller has an error to tell that says more
                self._temporary.unlink()


def _name(error: OSError, path: str | os.PathLike[str]) -> None:
    """Name the user's path in an error rather than the temporary file."""
    error.filename, error.filename2 = os.fspath(path), None


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
