"""The error of a launch file that does not exist."""

from __future__ import annotations

import errno
import os
from pathlib import Path

from tfloom.launch.missing import marked_as_missing
from tfloom.launch.utilities.nearest import nearest

__all__ = ["check_file"]


_EXTENSIONS = (".py", ".xml", ".yaml", ".yml")


class _MissingFileError(FileNotFoundError):
    """No file has a path; the text names the nearest one that exists."""

    def __str__(self) -> str:
        return f"{super().__str__()}{self._hint()}"

    def _hint(self) -> str:
        path = Path(str(self.filename))
        try:
            names = sorted(sibling.name for sibling in path.parent.iterdir())
        except OSError:
            return f" (there is no folder '{path.parent}')"
        files = {_stem(name): name for name in reversed(names) if name.endswith(_EXTENSIONS)}
        near = nearest(_stem(path.name), files)
        return "" if near is None else f"; did you mean '{files[near]}'?"


def _stem(name: str) -> str:
    """Return what is before `.launch.py`, because a common ending does not make names similar."""
    return name.partition(".")[0]


def check_file(path: str) -> None:
    """Check that a launch file exists.

    Raises:
        FileNotFoundError: no file has this path.
        IsADirectoryError: it is a folder.
    """
    if Path(path).is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), path)
    if not Path(path).exists():
        raise marked_as_missing(_MissingFileError(errno.ENOENT, os.strerror(errno.ENOENT), path))
