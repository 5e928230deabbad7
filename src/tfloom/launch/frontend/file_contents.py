"""The content of a launch file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TextIO

__all__ = ["read_content"]


def read_content(file: str | os.PathLike[str] | TextIO) -> tuple[str, bytes]:
    """Return the path and the content of a file.

    Args:
        file: Its path, or the open file; without a name, `<string>` stands for the path.

    Raises:
        OSError: it cannot be read.
    """
    if isinstance(file, (str, os.PathLike)):
        return os.fspath(file), Path(file).read_bytes()
    content = file.read()
    name = str(getattr(file, "name", "<string>"))
    return name, content.encode() if isinstance(content, str) else content
