"""The threads that are running callbacks."""

from __future__ import annotations

import threading

__all__ = ["RunningWork"]


_threads_of_all: list[int] = []
"""The threads that run callbacks of any executor, once for each callback. Changed as `RunningWork._threads`."""


class RunningWork:
    """Counts running callbacks, and waits for their end."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._waiters = 0
        # Changed without the lock, by single operations of a list, because a lock would cost time in each callback.
        self._threads: list[int] = []
        self.begun_count = 0
        """Number of callbacks that have begun, and responses that were taken. Changed by the thread that spins."""
        self._seen_counts: dict[int, int] = {}
        """`begun_count` when each thread last began a callback, or looked. Changed by single operations."""

    def __enter__(self) -> None:
        thread = threading.get_ident()
        self._threads.append(thread)
        self._seen_counts[thread] = self.begun_count
        _threads_of_all.append(thread)

    def __exit__(self, *_: object) -> None:
        thread = threading.get_ident()
        _threads_of_all.remove(thread)
        self._threads.remove(thread)
        self._seen_counts.pop(thread, None)
        if self._waiters:  # a waiter that isn't counted yet checks the list before it waits
            with self._changed:
                self._changed.notify_all()

    def is_this_thread(self) -> bool:
        """Return whether a callback runs on the calling thread."""
        return threading.get_ident() in self._threads

    @staticmethod
    def is_any_on_this_thread() -> bool:
        """Return whether a callback of any executor runs on the calling thread."""
        return threading.get_ident() in _threads_of_all

    def note_begun(self) -> None:
        """Count a callback that begins, or a response; the thread that spins calls this."""
        self.begun_count += 1
        thread = threading.get_ident()
        if thread in self._seen_counts:  # a callback that spins has begun this one itself
            self._seen_counts[thread] = self.begun_count

    def has_begun_another(self) -> bool:
        """Return whether a callback has begun since this thread began its own, or called this and got True."""
        thread, begun_count = threading.get_ident(), self.begun_count
        if self._seen_counts.setdefault(thread, begun_count) == begun_count:
            return False
        self._seen_counts[thread] = begun_count
        return True

    def wait(self, timeout_s: float | None) -> bool:
        """Wait until no callback runs on another thread; False after `timeout_s` [s] (None: no limit)."""
        me = threading.get_ident()

        def is_over() -> bool:
            return all(thread == me for thread in list(self._threads))

        with self._changed:
            self._waiters += 1
            try:
                return self._changed.wait_for(is_over, timeout_s)
            finally:
                self._waiters -= 1
