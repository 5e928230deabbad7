"""Which threads run callbacks now."""

from __future__ import annotations

import threading

__all__ = ["RunningWork"]


class RunningWork:
    """Counts the callbacks that run, for whoever must wait for their end."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._waiters = 0
        # Changed without the lock, by single operations: a callback's begin and end are too frequent for one.
        self._threads: list[int] = []

    def __enter__(self) -> None:
        self._threads.append(threading.get_ident())

    def __exit__(self, *_: object) -> None:
        self._threads.remove(threading.get_ident())
        if self._waiters:  # who has not counted itself yet sees the end when it looks
            with self._changed:
                self._changed.notify_all()

    def is_this_thread(self) -> bool:
        """Return whether a callback runs on the thread that asks."""
        return threading.get_ident() in self._threads

    def wait(self, timeout_s: float | None) -> bool:
        """Wait until no callback runs, but for the one this is called from; False after `timeout_s`."""
        me = threading.get_ident()

        def is_over() -> bool:
            return all(thread == me for thread in list(self._threads))

        with self._changed:
            self._waiters += 1
            try:
                return self._changed.wait_for(is_over, timeout_s)
            finally:
                self._waiters -= 1
