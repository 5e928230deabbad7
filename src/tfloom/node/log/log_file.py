"""The log file of a program, written besides the console."""

from __future__ import annotations

import os
import sys
import threading
import time
from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from pathlib import Path

# Importing pathlib would take longer than the rest of a program's first log line.
# ruff: noqa: PTH103, PTH111, PTH118, PTH119, PTH122, PTH123

__all__ = ["LogFile", "log_directory"]


class LogFile:
    """A file of log lines, opened with the first of them.

    If it can't be opened, one line on the console reports that, and nothing is written.

    Args:
        name: Part of the file's name before the process id; None: the program's name.
    """

    def __init__(self, name: str | None = None) -> None:
        self._name = name
        self._file: TextIO | None = None
        self._closed = False
        self._lock = threading.RLock()

    def write(self, line: str) -> None:
        """Write a line, from any thread; do nothing after `close`."""
        with self._lock:
            if self._closed:
                return
            try:
                if self._file is None:
                    self._file = self._open()
                self._file.write(f"{line}\n")
                self._file.flush()
            except (OSError, ValueError) as error:
                self.close()
                if sys.stderr is not None:
                    print(f"tfloom: no log file in {_directory()}: {error}", file=sys.stderr)

    def _open(self) -> TextIO:
        import atexit

        directory = _directory()
        os.makedirs(directory, exist_ok=True)
        atexit.register(self.close)
        name = f"{self._name or _program()}_{os.getpid()}_{time.time_ns() // 1_000_000}.log"
        return open(os.path.join(directory, name), "w", encoding="utf-8", errors="backslashreplace")

    def reset_in_forked_child(self) -> None:
        """In a forked child, make a new lock, because a thread of the parent may have held it."""
        self._lock = threading.RLock()

    def close(self) -> None:
        """Close the file, if there is one, permanently."""
        with self._lock:
            self._closed = True
            file, self._file = self._file, None
        if file is not None:
            import atexit

            atexit.unregister(self.close)
            file.close()


def log_directory() -> Path:
    """Return the folder of log files: `ROS_LOG_DIR`, else `log` in `ROS_HOME`, else `~/.ros/log`."""
    from pathlib import Path

    return Path(_directory())


def _directory() -> str:
    directory = os.environ.get("ROS_LOG_DIR")
    if directory:
        return os.path.expanduser(directory)
    return os.path.join(os.path.expanduser(os.environ.get("ROS_HOME") or "~/.ros"), "log")


def _program() -> str:
    name = os.path.splitext(os.path.basename(sys.argv[0]))[0] if sys.argv else ""
    return name if name not in ("", "-c", "-m") else "python3"
