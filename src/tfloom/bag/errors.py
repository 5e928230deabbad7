"""Errors of recordings."""

from __future__ import annotations

import os

__all__ = ["BagError", "BagWarning"]


class BagError(RuntimeError):
    """A recording can't be read or written; the text states the file, the place in it, and what to do.

    Attributes:
        path: The file or folder.
        offset: The byte in the file; None if the error has no place.
    """

    def __init__(self, path: str | os.PathLike[str], reason: str, offset: int | None = None) -> None:
        self.path = os.fspath(path)
        self.offset = offset
        place = "" if offset is None else f": byte {offset}"
        super().__init__(f"{self.path}{place}: {reason}")


class BagWarning(UserWarning):
    """A recording was read only in part, because it is unfinished or damaged."""
