"""A buffer in a file: frozen at one time, and mapped back."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from tfloom.tf2.arrays import Arrays

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["Files"]


class Files(Arrays):
    """The part of a buffer that writes and maps files."""

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
