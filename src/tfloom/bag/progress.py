"""A line of progress on a terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

__all__ = ["progress_line"]

AFTER_S = 1.0
"""How long work takes before the line is shown [s]."""
EACH_S = 0.1
WIDTH = 30


@contextmanager
def progress_line(text: str, total: int, is_shown: bool | None) -> Iterator[Callable[[int], object]]:
    """Show how much of some work is done, for the block.

    Args:
        text: What is done.
        total: The whole, in any unit.
        is_shown: Whether to show it; None: if standard error is a terminal and the work takes more than a second.

    Yields:
        A function that adds to what is done.
    """
    if is_shown is None:
        is_shown = sys.stderr is not None and sys.stderr.isatty()
        first = time.monotonic() + AFTER_S
    else:
        first = 0.0
    if not is_shown or total <= 0:
        yield lambda _: None
        return
    line = _Line(text, total, first)
    try:
        yield line.advance
    finally:
        line.end()


class _Line:
    def __init__(self, text: str, total: int, first: float) -> None:
        self._text = text
        self._total = total
        self._done = 0
        self._next = first
        self._width = 0

    def advance(self, amount: int) -> None:
        """Add to what is done, and show it if the last time was long ago."""
        self._done += amount
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + EACH_S
        share = min(1.0, self._done / self._total)
        bar = "#" * round(share * WIDTH)
        shown = f"{self._text} [{bar:<{WIDTH}}] {share:4.0%}"
        self._width = len(shown)
        sys.stderr.write(f"\r{shown}")
        sys.stderr.flush()

    def end(self) -> None:
        """Erase the line, if one was drawn, so that what is printed next begins at the left."""
        if self._width:
            sys.stderr.write(f"\r{' ' * self._width}\r")
            sys.stderr.flush()
