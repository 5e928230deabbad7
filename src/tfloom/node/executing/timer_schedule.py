"""The deadlines of timers."""

from __future__ import annotations

from heapq import heapify, heappop, heappush

__all__ = ["TimerSchedule"]


class TimerSchedule:
    """Deadlines of tokens, by the steady clock [ns]; one for each token."""

    def __init__(self) -> None:
        self._heap: list[tuple[int, int]] = []
        self._deadlines: dict[int, int] = {}

    def set(self, token: int, deadline_ns: int | None) -> None:
        """Set the deadline of a token; None removes it."""
        if deadline_ns is None:
            self._deadlines.pop(token, None)
        elif self._deadlines.get(token) != deadline_ns:
            self._deadlines[token] = deadline_ns
            heappush(self._heap, (deadline_ns, token))
            # Replaced deadlines stay in the heap until they are its smallest.
            if len(self._heap) > 64 + 2 * len(self._deadlines):
                self._heap = [(deadline, each) for each, deadline in self._deadlines.items()]
                heapify(self._heap)

    def next_ns(self) -> int | None:
        """Return the earliest deadline, or None."""
        while self._heap:
            deadline_ns, token = self._heap[0]
            if self._deadlines.get(token) == deadline_ns:
                return deadline_ns
            heappop(self._heap)
        return None

    def take_due(self, now_ns: int) -> list[int]:
        """Remove and return the tokens whose deadline has passed, the earliest first."""
        due: list[int] = []
        while (deadline_ns := self.next_ns()) is not None and deadline_ns <= now_ns:
            _, token = heappop(self._heap)
            del self._deadlines[token]
            due.append(token)
        return due
