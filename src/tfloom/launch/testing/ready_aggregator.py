"""One report that all of several processes are ready."""

from __future__ import annotations

import threading
from collections.abc import Callable

__all__ = ["ReadyAggregator"]


class ReadyAggregator:
    """Calls a function when `ready_fn` has been called for the last process, on any thread.

    Args:
        callback: Called once, on the thread of that call.
        num_needed: Number of calls.
    """

    def __init__(self, callback: Callable[[], object], num_needed: int) -> None:
        self._callback = callback
        self._missing = num_needed  # guarded by _lock
        self._lock = threading.Lock()

    def ready_fn(self) -> None:
        """Count one process as ready."""
        with self._lock:
            self._missing -= 1
            is_last = self._missing == 0
        if is_last:
            self._callback()
