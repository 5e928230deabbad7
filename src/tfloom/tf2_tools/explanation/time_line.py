"""A time-line in text: a row for each edge, in which the time that its history covers is filled."""

from __future__ import annotations

from collections.abc import Sequence

from tfloom.tf2_tools.explanation.chain import Span
from tfloom.tf2_tools.text.times import ago

__all__ = ["TimeLine"]

WIDTH = 40
COVERED, EMPTY, MARK = "=", ".", "|"


class TimeLine:
    """Columns of equal time, from the oldest stamp to now.

    Args:
        spans: The edges.
        stamp_ns: The time to mark; 0: none.
        now_ns: The time at the right end, unless a stamp is later.
        now: What that time is called.
    """

    def __init__(self, spans: Sequence[Span], stamp_ns: int, now_ns: int, now: str) -> None:
        moving = [span for span in spans if not span.is_static]
        marked = [stamp_ns] if stamp_ns else []
        self._now_ns = now_ns
        self._now = now
        self._stamp_ns = stamp_ns
        self._begin_ns = min([span.oldest_ns for span in moving] + marked, default=now_ns)
        self._end_ns = max([now_ns, *(span.newest_ns for span in moving), *marked])

    def _column(self, stamp_ns: int) -> int:
        length_ns = max(1, self._end_ns - self._begin_ns)
        return round((WIDTH - 1) * (stamp_ns - self._begin_ns) / length_ns)

    def row(self, span: Span) -> str:
        """Return the row of an edge."""
        if span.is_static:
            return " static, valid at any time ".center(WIDTH, COVERED)
        first, last = self._column(span.oldest_ns), self._column(span.newest_ns)
        cells = [COVERED if first <= column <= last else EMPTY for column in range(WIDTH)]
        if self._stamp_ns:
            cells[self._column(self._stamp_ns)] = MARK
        return "".join(cells)

    def axis(self) -> str:
        """Return the row with the times at both ends."""
        left, right = ago(self._begin_ns, self._now_ns), ago(self._end_ns, self._now_ns)
        right = self._now if self._end_ns == self._now_ns else right
        return f"{left}{right.rjust(WIDTH - len(left))}"

    def pointer(self, text: str) -> str:
        """Return the row that points to the marked time, with a text beside it."""
        column = self._column(self._stamp_ns)
        if column + 2 + len(text) <= WIDTH or column < len(text) + 1:
            return f"{' ' * column}^ {text}"
        return f"{text} ^".rjust(column + 1)
