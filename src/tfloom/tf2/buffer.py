"""The buffer: stores transforms between frames and returns the transform between any two at any stored time.

It is frozen to a file, and mapped back.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from tfloom.tf2.velocity import Velocities

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["LATEST", "Buffer"]

LATEST = 0
"""Stamp of a query for the newest time at which the whole chain is known."""

DEFAULT_CACHE_TIME_NS = 10_000_000_000


class Buffer(Velocities):
    """A tree of frames over time. All methods may be called from any thread.

    Args:
        cache_time_ns: Length of each frame's history, before its newest sample [ns]; None: no limit.

    Rejected transforms are logged to the logger ``tfloom.tf2``, or by the function of `set_log_callback`.
    """

    def __init__(self, cache_time_ns: int | None = DEFAULT_CACHE_TIME_NS) -> None:
        super().__init__(cache_time_ns)
        self.set_log_callback(_log)

    def freeze(self, path: str | os.PathLike[str]) -> None:
        """Write all that is stored to a file that `map` reads.

        The file appears complete or not at all. It replaces a previous one, whose mappings keep the previous content.
        Inserts are blocked while the samples are copied to memory, but not while they are written.

        Args:
            path: File to write; its folder must exist.

        Raises:
            OSError: the file can't be written.
        """
        from tfloom.common.files import write_file

        write_file(path, self.frozen())

    @classmethod
    def map(cls, path: str | os.PathLike[str]) -> Self:
        """Return a buffer with the content of a file: its lookups return what those of the frozen buffer returned.

        The file is mapped for reading: samples stay in it until they are read, and processes that map the same file
        share them. The file stays unchanged: inserts are kept in memory. It must not be overwritten or truncated in
        place while it is mapped; `freeze` to the same path is allowed.

        Args:
            path: File that `freeze` wrote.

        Raises:
            OSError: the file can't be read.
            ValueError: it is not a frozen buffer, or incomplete; the text has the defect and its byte.
        """
        from mmap import ACCESS_READ, mmap
        from pathlib import Path

        with Path(path).open("rb") as file:
            is_empty = os.fstat(file.fileno()).st_size == 0  # mmap rejects an empty file
            data = memoryview(b"" if is_empty else mmap(file.fileno(), 0, access=ACCESS_READ))
        buffer = cls()
        try:
            buffer.map_frozen(data)
        except ValueError as error:
            raise ValueError(f"{os.fspath(path)}: {error}") from None
        return buffer


def _log(severity: int, text: str) -> None:
    import logging

    logging.getLogger("tfloom.tf2").log(severity, text)
