"""The error of a launch file that does not exist."""

from __future__ import annotations

import errno
import os
from pathlib import Path

from tfloom.launch.utilities.nearest import did_you_mean

__all__ = ["check_file"]


class _MissingFileError(FileNotFoundError):
    """No file has a path; the text names the nearest one that exists."""

    def __str__(self) -> str:
        return f"{super().__str__()}{self._near()}"

    def _near(self) -> str:
        path = Path(str(self.filename))
        try:
            names = [each.name for each in path.parent.iterdir()]
        except OSError:
            return "" if path.parent == Path() else f" (there is no folder '{path.parent}')"
        return did_you_mean(path.name, names)


def check_file(path: str) -> None:
    """Check that a launch file exists.

    Raises:
        FileNotFoundError: no file has this path.
        IsADirectoryError: it is a folder.
    """
    if Path(path).is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), path)
    if not Path(path).exists():
        raise _MissingFileError(errno.ENOENT, os.strerror(errno.ENOENT), path)
