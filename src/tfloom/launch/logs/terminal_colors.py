"""Colors of a launch's lines on a terminal: of a level, and one for each process."""

from __future__ import annotations

import os
import zlib
from collections.abc import Callable
from typing import Any

__all__ = ["Colors", "colors_of"]

Colors = Callable[[str, str, str], str]
"""Takes a line, its level and its logger's name; returns it with colors."""

RESET = "\033[0m"
LEVELS = {"WARNING": "\033[33m", "ERROR": "\033[31m", "CRITICAL": "\033[31m", "DEBUG": "\033[2m"}
PROCESSES = tuple(f"\033[{number}m" for number in (36, 32, 35, 34, 96, 92, 95, 94))
"""Neither red nor yellow, which are those of levels."""

STREAMS = ("-stdout", "-stderr")


def colors_of(stream: Any) -> Colors | None:
    """Return how lines on a stream are colored; None where it is not a terminal, or NO_COLOR is set."""
    if stream is None or os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb":
        return None
    try:
        return _colored_line if stream.isatty() else None
    except (AttributeError, ValueError):  # a closed file
        return None


def _colored_line(line: str, level: str, name: str) -> str:
    if name.endswith(STREAMS):
        end = line.find("]") + 1
        color = PROCESSES[zlib.crc32(name.rpartition("-")[0].encode()) % len(PROCESSES)]
        return f"{color}{line[:end]}{RESET}{line[end:]}"
    color = LEVELS.get(level, "")
    return f"{color}{line}{RESET}" if color else line
