"""The KeyboardInterrupt of a Ctrl-C that arrived where an exception would be lost, until it is raised.

It would be lost in functions that a wire's library calls, on any thread, because the library prints and drops
exceptions. It is raised as soon as they have returned: see `node/executing/signals.py`.
"""

from __future__ import annotations

import threading

__all__ = ["PostponedInterrupt", "postponed", "uninterrupted_files"]

uninterrupted_files: set[str] = set()
"""The files that hold such functions, named as in code objects; the modules add themselves."""


class PostponedInterrupt:
    """Whether a KeyboardInterrupt is still to be raised. Only the main thread changes it, others read it."""

    def __init__(self) -> None:
        self._due_s: float | None = None

    def set(self, due_s: float) -> None:
        """Postpone it until `due_s` at most, on the monotonic clock [s]."""
        self._due_s = due_s

    def is_set(self) -> bool:
        """Return whether one is still to be raised."""
        return self._due_s is not None

    def is_overdue(self, now_s: float) -> bool:
        """Return whether one is to be raised wherever the program is."""
        return self._due_s is not None and now_s >= self._due_s

    def take(self) -> bool:
        """Return whether the caller has to raise it; on other threads than the main one, return False."""
        if self._due_s is None or threading.current_thread() is not threading.main_thread():
            return False
        self._due_s = None
        return True


postponed = PostponedInterrupt()
"""That of the process, which has one main thread."""
