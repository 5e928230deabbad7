"""The thread of a recorder that looks for topics, which may be started and stopped while it records."""

from __future__ import annotations

import threading
from collections.abc import Callable

__all__ = ["Discovery"]


class Discovery:
    """Looks for topics on a thread of its own, from `start` until all are found, a look fails, or `stop`.

    One thread at a time calls `start` and `stop`.

    Args:
        look: Called on that thread, at intervals; returns whether no more topics are to be found.
        interval_s: How long it waits before each look [s].
        on_failure: Called with an error of `look`, after which there are no more looks.
    """

    def __init__(
        self, look: Callable[[], bool], interval_s: float, on_failure: Callable[[Exception], None]
    ) -> None:
        self._look = look
        self._interval_s = interval_s
        self._on_failure = on_failure
        self._stopped = threading.Event()
        self._thread: threading.Thread | None = None

    @property
    def is_running(self) -> bool:
        """Whether topics are being looked for."""
        thread = self._thread
        return thread is not None and thread.is_alive()

    def start(self) -> None:
        """Begin to look. The last thread must have ended.

        Raises:
            RuntimeError: a thread can't be started.
        """
        self._stopped.clear()
        thread = threading.Thread(target=self._run, daemon=True)
        thread.start()
        self._thread = thread

    def stop(self) -> None:
        """End the thread, and wait until it has ended. It does nothing if there is none."""
        self._stopped.set()
        if self._thread is not None:
            self._thread.join()

    def _run(self) -> None:
        try:
            while not self._stopped.wait(self._interval_s):
                if self._look():
                    return
        except Exception as error:  # else topics that come later would be missing in silence
            self._on_failure(error)
