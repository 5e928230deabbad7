"""The queue that an endpoint posts to: its executor's, or that of a thread that waits for its data itself."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue

__all__ = ["QueueSwitch"]


class QueueSwitch:
    """Switches the queue that an endpoint posts to, so that a thread that waits for its data is the only one to wake.

    The methods may be called from any thread.

    Args:
        notify: Makes the endpoint post a token to a queue, at once if there is something to take; None ends it.
    """

    def __init__(self, notify: Callable[[ReadyQueue | None, int], None]) -> None:
        self._notify = notify
        self._lock = threading.Lock()
        """Guards the next two, and the order of calls of `notify`."""
        self._usual: tuple[ReadyQueue | None, int] = (None, 0)
        """The executor's queue and the endpoint's token there."""
        self._waiting: list[tuple[ReadyQueue, int]] = []
        """The queue and token of each thread that waits; the endpoint posts to the first."""

    def attach(self, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to an executor's queue, while no thread waits; None: to none."""
        with self._lock:
            self._usual = (queue, token)
            if not self._waiting:
                self._notify(queue, token)

    def post(self) -> None:
        """Post the endpoint's token to the executor's queue, if there is one."""
        with self._lock:
            queue, token = self._usual
            if queue is not None:
                queue.post(token)

    def divert(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` to the queue of a thread that waits, which takes all data until `restore`."""
        with self._lock:
            self._waiting.append((queue, token))
            if len(self._waiting) == 1:
                self._notify(queue, token)

    def forward(self, queue: ReadyQueue) -> None:
        """Post for whoever waits beside the thread of a queue, which took data and has not consumed them."""
        with self._lock:
            for other, token in (*self._waiting, self._usual):
                if other is not None and other is not queue:
                    other.post(token)

    def refresh(self) -> None:
        """Have the endpoint, which was replaced, post to where the former one did."""
        with self._lock:
            self._notify(*(self._waiting[0] if self._waiting else self._usual))

    def restore(self, queue: ReadyQueue) -> None:
        """Undo `divert`: post to the next thread that waits, or to the executor's queue."""
        with self._lock:
            was_first = self._waiting[0][0] is queue
            self._waiting = [waiter for waiter in self._waiting if waiter[0] is not queue]
            if was_first:
                self._notify(*(self._waiting[0] if self._waiting else self._usual))
