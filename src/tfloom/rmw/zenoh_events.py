"""The events of writers and readers on the Zenoh wire, which itself has none: they follow from tokens and samples.

A thread counts missed deadlines and ended leases. It is started with the first endpoint that has one.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from contextlib import suppress

from tfloom._native import ReadyQueue
from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import Count, Event, IncompatibleQoS, LivelinessChanged, Matched, Status
from tfloom.rmw.qos import QoSPolicyKind

__all__ = ["LostSamples", "Timers", "ZenohEvents"]

WRITER_EVENTS = frozenset(
    {Event.MATCHED, Event.INCOMPATIBLE_QOS, Event.DEADLINE_MISSED, Event.LIVELINESS_LOST}
)
READER_EVENTS = frozenset(
    {
        Event.MATCHED,
        Event.INCOMPATIBLE_QOS,
        Event.DEADLINE_MISSED,
        Event.LIVELINESS_CHANGED,
        Event.MESSAGE_LOST,
    }
)
MAX_COUNT = 0x7FFF_FFFF
"""The largest number of a status: ROS has 32 bits for it."""
MAX_GAP = 64
"""How many missing samples of one writer are remembered, in case that they come late."""
MAX_WRITERS = 1024
"""How many writers are remembered that no token tells of."""


class ZenohEvents:
    """The statuses of one endpoint, and the queues to notify. All methods may be called from any thread."""

    def __init__(self, *, is_writer: bool) -> None:
        self._kind = "writer" if is_writer else "reader"
        self._known = WRITER_EVENTS if is_writer else READER_EVENTS
        self._lock = threading.Lock()
        self._listeners: dict[Event, tuple[ReadyQueue, int]] = {}
        self._matched = Matched(0, 0, 0, 0)
        self._incompatible = IncompatibleQoS(0, 0, QoSPolicyKind.INVALID)
        self._liveliness = LivelinessChanged(0, 0, 0, 0)
        self._counts: dict[Event, Count] = {}

    def invalidate_after_fork(self) -> None:
        """Replace the lock, which a thread of the parent may have held."""
        self._lock = threading.Lock()

    def matched_count(self) -> int:
        """Return how many compatible peers are connected now."""
        return self._matched.current_count

    def add_match(self, change: int) -> None:
        """Count a peer that has come (1) or left (-1)."""
        with self._lock:
            was = self._matched
            new = max(change, 0)
            self._matched = Matched(
                was.total_count + new,
                was.total_count_change + new,
                was.current_count + change,
                was.current_count_change + change,
            )
            self._post(Event.MATCHED)

    def add_incompatible(self, kind: QoSPolicyKind) -> None:
        """Count a peer of an incompatible quality of service."""
        with self._lock:
            was = self._incompatible
            self._incompatible = IncompatibleQoS(was.total_count + 1, was.total_count_change + 1, kind)
            self._post(Event.INCOMPATIBLE_QOS)

    def change_liveliness(self, alive: int, not_alive: int) -> None:
        """Add to the numbers of writers that are alive, and that aren't."""
        with self._lock:
            was = self._liveliness
            self._liveliness = LivelinessChanged(
                was.alive_count + alive,
                was.not_alive_count + not_alive,
                was.alive_count_change + alive,
                was.not_alive_count_change + not_alive,
            )
            self._post(Event.LIVELINESS_CHANGED)

    def count(self, event: Event, more: int = 1) -> None:
        """Count a missed deadline, a lost liveliness or lost samples."""
        with self._lock:
            was = self._counts.get(event, Count(0, 0))
            self._counts[event] = Count(
                min(was.total_count + more, MAX_COUNT), min(was.total_count_change + more, MAX_COUNT)
            )
            self._post(event)

    def _post(self, event: Event) -> None:
        if listener := self._listeners.get(event):
            listener[0].post(listener[1])

    def notify(self, event: Event, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when the event has a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: this kind of endpoint has no such event.
        """
        self._check(event)
        with self._lock:
            if queue is None:
                self._listeners.pop(event, None)
            else:
                self._listeners[event] = (queue, token)
                queue.post(token)

    def take(self, event: Event) -> Status | None:
        """Return the status of an event if it has changed since the last call, or None.

        Raises:
            UnsupportedEventError: this kind of endpoint has no such event.
        """
        self._check(event)
        with self._lock:
            if event == Event.MATCHED:
                matched = self._matched
                self._matched = matched._replace(total_count_change=0, current_count_change=0)
                return matched if matched.total_count_change or matched.current_count_change else None
            if event == Event.INCOMPATIBLE_QOS:
                incompatible = self._incompatible
                self._incompatible = incompatible._replace(total_count_change=0)
                return incompatible if incompatible.total_count_change else None
            if event == Event.LIVELINESS_CHANGED:
                liveliness = self._liveliness
                self._liveliness = liveliness._replace(alive_count_change=0, not_alive_count_change=0)
                has_changed = liveliness.alive_count_change or liveliness.not_alive_count_change
                return liveliness if has_changed else None
            count = self._counts.get(event, Count(0, 0))
            self._counts[event] = count._replace(total_count_change=0)
            return count if count.total_count_change else None

    def _check(self, event: Event) -> None:
        if event not in self._known:
            raise UnsupportedEventError(f"{event.name}: a {self._kind} has no such event")


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
        self._checks: dict[int, tuple[float, Callable[[float], float]]] = {}
        """The time of the next call [s], and the function, by its number."""
        self._next_number = 0
        self._thread: threading.Thread | None = None
        self._is_closed = False

    def add(self, first_s: float, check: Callable[[float], float]) -> int:
        """Call `check(now)` at `first_s`, and then at each time that it returns, on the monotonic clock [s].

        Returns:
            The number for `remove`.

        Raises:
            RuntimeError: the system has no thread.
        """
        with self._changed:
            self._next_number += 1
            number = self._next_number
            self._checks[number] = first_s, check
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

    def _run(self) -> None:
        while True:
            with self._changed:
                if self._is_closed:
                    return
                now_s = time.monotonic()
                due = [(number, check) for number, (at_s, check) in self._checks.items() if at_s <= now_s]
                if not due:
                    next_s = min((at_s for at_s, _ in self._checks.values()), default=None)
                    self._changed.wait(None if next_s is None else min(next_s - now_s, threading.TIMEOUT_MAX))
                    continue
            for number, check in due:
                again_s = check(now_s)
                with self._changed:
                    if number in self._checks:
                        self._checks[number] = again_s, check

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._checks.clear()
            self._changed.notify()
            thread, self._thread = self._thread, None
        if thread is not None and thread is not threading.current_thread():
            with suppress(RuntimeError):
                thread.join()
