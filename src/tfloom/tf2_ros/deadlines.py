"""Calls at a later time, all on one thread that starts with the first of them."""

from __future__ import annotations

import heapq
import threading
import time
from collections.abc import Callable
from itertools import count

__all__ = ["call_after"]

_waiting: list[tuple[float, int, Callable[[], None]]] = []
_numbers = count()
_changed = threading.Condition()
_thread: threading.Thread | None = None


def call_after(delay_s: float, function: Callable[[], None]) -> None:
    """Have `function()` called once, after `delay_s` by the steady clock, on a thread that all such calls share."""
    global _thread  # noqa: PLW0603, one for the process
    with _changed:
        heapq.heappush(_waiting, (time.monotonic() + delay_s, next(_numbers), function))
        if _thread is None or not _thread.is_alive():
            _thread = threading.Thread(target=_run, name="tf2_deadlines", daemon=True)
            _thread.start()
        _changed.notify()


def _run() -> None:
    while True:
        with _changed:
            while not _waiting or _waiting[0][0] > time.monotonic():
                _changed.wait(_waiting[0][0] - time.monotonic() if _waiting else None)
            function = heapq.heappop(_waiting)[2]
        function()
