"""The deadlines of timers."""

from __future__ import annotations

from bisect import bisect_left, insort

__all__ = ["TimerSchedule"]


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
        """Return the earliest deadline, or None."""
        return self._order[0][0] if self._order else None

    def take_due(self, now_ns: int) -> list[int]:
        """Remove and return the tokens whose deadline has passed, the earliest first."""
        if not self._order or self._order[0][0] > now_ns:
            return []
        count = bisect_left(self._order, (now_ns + 1, 0))
        due = [token for _, token in self._order[:count]]
        for token in due:
            self._deadlines.pop(token, None)
        del self._order[:count]
        return due
