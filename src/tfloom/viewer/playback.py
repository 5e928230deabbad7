"""The time of a recording that is played."""

from __future__ import annotations

import time
from collections.abc import Callable

from tfloom.viewer.frames import Span

__all__ = ["Playback"]


class Playback:
    """The time that pages of a recording show: it stands at first, and runs as fast as real time while it is played.

    Args:
        clock_s: Returns a steady time [s].
    """

    def __init__(self, clock_s: Callable[[], float] = time.monotonic) -> None:
        self.start_ns: int | None = None
        """Where it stands at first, and from where it is played again [ns since epoch]; None: the span's start."""
        self._clock_s = clock_s
        self._shown_ns: int | None = None
        self._started_s: float | None = None
        """When playing began at `_shown_ns`; None: it stands."""

    @property
    def is_playing(self) -> bool:
        """Whether the time runs."""
        return self._started_s is not None

    def now_ns(self, span: Span) -> int:
        """Return the time in the recording's span; at its end, playing ends."""
        shown_ns = self._first_ns(span) if self._shown_ns is None else self._shown_ns
        if self._started_s is not None:
            shown_ns += int((self._clock_s() - self._started_s) * 1e9)
            if shown_ns >= span.end_ns:
                self._started_s = None
                self._shown_ns = span.end_ns
        return span.clamped(shown_ns)

    def _first_ns(self, span: Span) -> int:
        return span.start_ns if self.start_ns is None else span.clamped(self.start_ns)

    def play(self, span: Span) -> None:
        """Let the time run; from the start, where it stands at the end."""
        shown_ns = self.now_ns(span)
        self._shown_ns = self._first_ns(span) if shown_ns >= span.end_ns else shown_ns
        self._started_s = self._clock_s()

    def pause(self, span: Span, at_ns: int | None = None) -> None:
        """Let the time stand: at one [ns since epoch], or where it is."""
        self._shown_ns = self.now_ns(span) if at_ns is None else span.clamped(at_ns)
        self._started_s = None
