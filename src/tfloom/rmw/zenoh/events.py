"""From what the events of the Zenoh wire, which itself has none, follow: gaps in the numbers of samples, and time.

A thread looks for missed deadlines and ended leases, and for routes to servers. It is started with the first one.
"""

from __future__ import annotations

import heapq
import math
import threading
import time
from collections.abc import Callable
from contextlib import suppress

__all__ = ["LostSamples", "Timers"]

MAX_GAP = 64
"""How many missing samples of one writer are remembered, in case that they come late."""
MAX_WRITERS = 1024
"""How many writers are remembered that have no token."""
MIN_PERIOD_S = 0.001
"""The least time between two calls of one check [s]: a deadline of a nanosecond costs no core."""
_MIN_STALE = 64


class LostSamples:
    """Counts the samples of each writer that never came, by gaps in their numbers.

    A gap is confirmed by the sample after the next one, because two threads that write at once may swap two samples.
    """

    def __init__(self) -> None:
        self._last: dict[bytes, int] = {}
        self._missing: dict[bytes, set[int]] = {}

    def knows(self, gid: bytes) -> bool:
        """Return whether a sample of this writer has come before."""
        return gid in self._last

    def add(self, gid: bytes, number: int) -> int:
        """Note a sample and return how many are known to be lost by it."""
        last = self._last.get(gid)
        missing = self._missing.get(gid)
        if last is None:
            if len(self._last) >= MAX_WRITERS:
                self.drop(next(iter(self._last)))
            self._last[gid] = number
            return 0
        if number <= last:
            if missing:
                missing.discard(number)
            return 0
        self._last[gid] = number
        lost = len(missing) if missing else 0
        gap = number - last - 1
        if gap > MAX_GAP:
            lost += gap
            gap = 0
        if missing or gap:
            self._missing[gid] = set(range(last + 1, number)) if gap else set()
        return lost

    def drop(self, gid: bytes) -> None:
        """Forget a writer that has left."""
        self._last.pop(gid, None)
        self._missing.pop(gid, None)


class Timers:
    """A thread that calls functions at their times."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._checks: dict[int, Callable[[float], float]] = {}
        """The functions by their numbers."""
        self._next: list[tuple[float, int]] = []
        """A heap of the times of the next calls [s], each with the number of its function, which may be removed."""
        self._next_number = 0
        self._thread: threading.Thread | None = None
        self._is_closed = False

    def add(self, first_s: float, check: Callable[[float], float]) -> int:
        """Call `check(now)` at `first_s`, and then at each time that it returns, on the monotonic clock [s].

        A check that returns infinity is removed. Two calls of one are `MIN_PERIOD_S` apart at least.

        Returns:
            The number for `remove`.

        Raises:
            RuntimeError: the system has no thread.
        """
        with self._changed:
            self._next_number += 1
            number = self._next_number
            self._checks[number] = check
            heapq.heappush(self._next, (first_s, number))
            if self._thread is None and not self._is_closed:
                thread = threading.Thread(target=self._run, name="tfloom_zenoh_timers", daemon=True)
                try:
                    thread.start()
                except RuntimeError:
                    del self._checks[number]
                    raise
                self._thread = thread
            self._changed.notify()
        return number

    def remove(self, number: int) -> None:
        """End the calls of a function; one that is running is not waited for."""
        with self._changed:
            self._checks.pop(number, None)
            if len(self._next) > 2 * len(self._checks) + _MIN_STALE:
                self._next = [entry for entry in self._next if entry[1] in self._checks]
                heapq.heapify(self._next)

    def _run(self) -> None:
        while True:
            with self._changed:
                if self._is_closed:
                    return
                now_s = time.monotonic()
                due = []
                while self._next and self._next[0][0] <= now_s:
                    _, number = heapq.heappop(self._next)
                    if (check := self._checks.get(number)) is not None:
                        due.append((number, check))
                if not due:
                    left_s = self._next[0][0] - now_s if self._next else None
                    self._changed.wait(None if left_s is None else min(left_s, threading.TIMEOUT_MAX))
                    continue
            for number, check in due:
                again_s = check(now_s)
                with self._changed:
                    if again_s == math.inf:
                        self._checks.pop(number, None)
                    elif number in self._checks:
                        heapq.heappush(self._next, (max(again_s, now_s + MIN_PERIOD_S), number))

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._checks.clear()
            self._next.clear()
            self._changed.notify()
            thread, self._thread = self._thread, None
        if thread is not None and thread is not threading.current_thread():
            with suppress(RuntimeError):  # Python refuses to wait for a thread while the interpreter ends
                thread.join()
