"""The deadlines of timers."""

from __future__ import annotations

from bisect import bisect_left, insort

__all__ = ["CELL_NS", "MIN_CROWD", "TimerSchedule"]

CELL_NS = 1_000_000
"""Length of the cells of the steady clock in which a crowd of deadlines shares one wake [ns].

A wake takes several times as much CPU time as the call of a timer: without this rule, a thousand timers at 10 Hz take
twice as much of a core (`benchmarks.node timers`). asyncio rounds each deadline up to a whole millisecond for the same
reason; here only a crowd waits, so that the few timers of most programs are met exactly. The cells are fixed, so that a
timer whose period is a multiple of their length is delayed by the same time in each of its periods.
"""

MIN_CROWD = 4
"""The least number of deadlines of a cell that share a wake. Fewer, as those of most programs, are met exactly."""


class TimerSchedule:
    """Deadlines of tokens, by the steady clock [ns]; one for each token."""

    def __init__(self) -> None:
        self._deadlines: dict[int, int] = {}
        self._order: list[tuple[int, int]] = []
        """Each deadline and its token, sorted. A signal handler that raises may leave one too many, without harm."""

    def set(self, token: int, deadline_ns: int | None) -> None:
        """Set the deadline of a token; None removes it."""
        before_ns = self._deadlines.get(token)
        if deadline_ns == before_ns:
            return
        if before_ns is not None:
            del self._deadlines[token]
            del self._order[bisect_left(self._order, (before_ns, token))]
        if deadline_ns is not None:
            insort(self._order, (deadline_ns, token))
            self._deadlines[token] = deadline_ns

    def wake_ns(self) -> int | None:
        """Return when to wake next: at the earliest deadline or, in a crowd, at the last one of its cell; or None."""
        order = self._order
        if not order:
            return None
        first_ns = order[0][0]
        last_of_cell_ns = first_ns - first_ns % CELL_NS + CELL_NS - 1
        if len(order) < MIN_CROWD or order[MIN_CROWD - 1][0] > last_of_cell_ns:
            return first_ns
        return order[self._count_until(last_of_cell_ns) - 1][0]

    def take_due(self, now_ns: int) -> list[int]:
        """Remove and return the tokens whose deadline has passed, the earliest first."""
        if not self._order or self._order[0][0] > now_ns:
            return []
        count = self._count_until(now_ns)
        due = [token for _, token in self._order[:count]]
        for token in due:
            self._deadlines.pop(token, None)
        del self._order[:count]
        return due

    def _count_until(self, time_ns: int) -> int:
        """Return the number of deadlines up to and including `time_ns`."""
        return bisect_left(self._order, (time_ns + 1, 0))
