"""The log file of a program, written besides the console."""

from __future__ import annotations

import os
import sys
import threading
import time
from typing import TYPE_CHECKING, TextIO

from tfloom.common.terminal import report

if TYPE_CHECKING:
    from pathlib import Path

# Importing pathlib would take longer than the rest of a program's first log line.
# ruff: noqa: PTH103, PTH111, PTH118, PTH119, PTH122, PTH123

__all__ = ["LogFile", "log_directory"]


class LogFile:
    """A file of log lines, opened with the first of them.

    If it can't be opened or written, as on a full disk, one line on the console reports that, and nothing more is
    written.

    Args:
        name: Part of the file's name before the process id; None: the program's name.
    """

    def __init__(self, name: str | None = None) -> None:
        self._name = name
        self._file: TextIO | None = None
        self._closed = False
        self._has_failed = False
        self._lock = threading.RLock()

    def write(self, line: str) -> None:
        """Write a line, from any thread; do nothing after `close`."""
        try:
            with self._lock:
                if self._closed:
                    return
                if self._file is None:
                    self._file = self._open()
                self._file.write(f"{line}\n")
                self._file.flush()
        except (OSError, ValueError) as error:
            file = self._file
            self._fail(
                f"the log file {file.name} ends here" if file else f"no log file in {_directory()}", error
            )
            self.close()

    def _fail(self, fault: str, error: Exception) -> None:
        """Report, once, why the file lacks lines."""
        with self._lock:
            was_failed, self._has_failed = self._has_failed, True
        if not was_failed:
            report(f"tfloom: {fault}: {error}")

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
            try:
                file.close()
            except OSError as error:
                self._fail(f"the log file {file.name} may lack lines", error)


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
