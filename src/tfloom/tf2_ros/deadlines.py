"""Delayed calls, all on one thread that starts at the first call."""

from __future__ import annotations

import heapq
import threading
import time
from collections.abc import Callable
from itertools import count

from tfloom.node.values.callback_errors import report_exception

__all__ = ["Deadline", "call_after"]

MAX_CANCELLED = 1000
"""Most cancelled calls in the heap before it is rebuilt."""

_waiting: list[tuple[float, int]] = []
_functions: dict[int, Callable[[], None]] = {}
_numbers = count()
_changed = threading.Condition()
_thread: threading.Thread | None = None


class Deadline:
    """A delayed call; `call_after` creates one."""

    def __init__(self, number: int) -> None:
        self._number = number

    def cancel(self) -> None:
        """Cancel the call, unless it has begun."""
        with _changed:
            # The entry stays in the heap, because finding it there would take a pass over all; without a function it is
            # skipped when its time comes. Only when cancelled entries prevail is the heap rebuilt without them:
            # otherwise calls with long delays that are always cancelled would fill the memory.
            _functions.pop(self._number, None)
            if len(_waiting) > 2 * len(_functions) + MAX_CANCELLED:
                _waiting[:] = [entry for entry in _waiting if entry[1] in _functions]
                heapq.heapify(_waiting)


def call_after(delay_s: float, function: Callable[[], None]) -> Deadline:
    """Call `function()` once, after `delay_s` by the steady clock, on a thread that all such calls share.

    Raises:
        RuntimeError: that thread doesn't run, and can't be started; the call will not be made.
    """
    global _thread  # noqa: PLW0603, one for the process
    with _changed:
        # It is not alive in a forked child, which has copies of the heap and of this variable, but not the thread.
        if _thread is None or not _thread.is_alive():
            _thread = threading.Thread(target=_run, name="tf2_deadlines", daemon=True)
            _thread.start()
        number = next(_numbers)
        _functions[number] = function
        # Numbers grow, so calls at equal times are made in the order in which they were asked for.
        heapq.heappush(_waiting, (time.monotonic() + delay_s, number))
        _changed.notify()
    return Deadline(number)


def _run() -> None:
    while True:
        with _changed:
            # Wait for the earliest entry. A new one notifies, because it may be earlier; then its time is looked at.
            while not _waiting or _waiting[0][0] > time.monotonic():
                left_s = _waiting[0][0] - time.monotonic() if _waiting else threading.TIMEOUT_MAX
                _changed.wait(min(left_s, threading.TIMEOUT_MAX))  # the longest possible wait
            function = _functions.pop(heapq.heappop(_waiting)[1], None)
        # Called without the lock, because the function may start or cancel another delayed call.
        if function is not None:
            _call(function)
        function = None  # while the thread waits, it keeps nothing of a user's alive


def _call(function: Callable[[], None]) -> None:
    try:
        function()
    except BaseException:  # the other calls of this thread must be made too
        report_exception()
