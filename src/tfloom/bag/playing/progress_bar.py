"""What `ros2 bag play` shows of its progress on a terminal."""

from __future__ import annotations

import sys
import threading
from enum import Enum
from typing import TextIO

__all__ = ["PlayStatus", "ProgressBar"]


class PlayStatus(Enum):
    """What a player is doing, by the letter that is shown."""

    RUNNING = "R"
    PAUSED = "P"
    DELAYED = "D"
    STOPPED = "S"


class ProgressBar:
    """Two lines with a bag's time, and how much of it is played, which stay at one place while logs are above them.

    Any thread may call its methods.

    Args:
        start_ns: The first log time that is played [ns since epoch].
        duration_ns: How much is played [ns].
        separation: Number of empty lines before the two.
        stream: Where they are written.
    """

    def __init__(
        self, start_ns: int, duration_ns: int, separation: int, stream: TextIO | None = None
    ) -> None:
        self._start_ns = start_ns
        self._duration_s = duration_ns / 1e9
        self._separation = max(separation, 0)
        self._stream = sys.stdout if stream is None else stream
        self._lock = threading.Lock()
        """Guards what is written, because two texts must not be mixed."""
        self._is_shown = False

    def show(self, now_ns: int, status: PlayStatus) -> None:
        """Show a time of the bag [ns since epoch]."""
        played_s = max(0.0, (now_ns - self._start_ns) / 1e9)
        # Each line is cleared before, because the one that it replaces may be longer. Then the cursor goes back up, so
        # that the next log is printed above, and what is shown next takes the place of this.
        lines = (
            *[""] * self._separation,
            "====== Playback Progress ======",
            f"[{now_ns // 10**9}.{now_ns % 10**9:09}] Duration {played_s:.2f}/{self._duration_s:.2f} [{status.value}]",
        )
        text = "".join(f"\033[2K{line}\n" for line in lines)
        with self._lock:
            self._is_shown = True
            self._write(f"{text}\033[{len(lines)}A")

    def end(self) -> None:
        """Leave what was shown last on the terminal: what is printed next is below it."""
        with self._lock:
            if self._is_shown:
                self._write("\n" * (self._separation + 2))
                self._is_shown = False

    def _write(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except (OSError, ValueError):  # nobody reads it any more; the bag is played all the same
            return
