"""Requests of clients, which arrive on threads of the SDK, for the thread of the node."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Hashable
from functools import partial
from typing import TYPE_CHECKING

from tfloom.foxglove.shares import Load, Shares

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["Commands"]

MAX_MESSAGES = 10_000
"""Number of messages of all clients that wait; further ones are dropped."""
MAX_BYTES = 100_000_000
"""Sum of their sizes."""
MAX_REQUESTS = 2000
"""Number of other requests of all clients that wait, as to publish a topic; further ones are dropped."""
DROPPED_S = 1.0
"""Least time between two sentences on what was dropped [s]."""


class Commands:
    """Runs functions on the node's thread, in the order in which they were put. Putting one never waits.

    Args:
        node: The node, whose executor runs them. An error of one of them is told, and the others run.
        say: Tells clients and the log a sentence; called on the node's thread.
    """

    def __init__(self, node: Node, say: Callable[[str], None]) -> None:
        self._say = say
        self._waiting: queue.SimpleQueue[tuple[Callable[[], None], Callable[[], None]]] = queue.SimpleQueue()
        """Each function, and what is called before it."""
        self._messages, self._requests = Load(MAX_MESSAGES, MAX_BYTES), Shares(MAX_REQUESTS)
        """What waits of each client."""
        self._lock = threading.Lock()
        """Guards the members below."""
        self._latest: dict[Hashable, Callable[[], None]] = {}
        """The functions that were put by `put_latest` and wait."""
        self._dropped: dict[int, int] = {}
        """How much of each client was dropped since this was told last."""
        self._next_dropped_s = 0.0
        """When it is told next, on the monotonic clock [s]."""
        self._guard = node.create_guard_condition(self._run)

    def put_latest(self, key: Hashable, command: Callable[[], None]) -> None:
        """Run a function in place of one of the same key that still waits: only what was asked for last counts.

        So there are never more of these than keys, however often a client changes its mind.
        """
        with self._lock:
            is_waiting = key in self._latest
            self._latest[key] = command
        if not is_waiting:
            self._put(partial(self._run_latest, key))

    def _run_latest(self, key: Hashable) -> None:
        with self._lock:
            command = self._latest.pop(key)
        command()

    def put_message(self, client: int, size: int, command: Callable[[], None]) -> None:
        """Run a function for a message of a client, of a size [bytes]; it is dropped if too much waits."""
        if self._messages.take(client, size):
            self._put(command, partial(self._messages.give_back, client, size))
        else:
            self._drop(client)

    def put_request(self, client: int, command: Callable[[], None]) -> bool:
        """Run a function for another request; return False if it is dropped, because too many wait."""
        if not self._requests.take(client):
            self._drop(client)
            return False
        self._put(command, partial(self._requests.give_back, client))
        return True

    def put_end(self, command: Callable[[], None]) -> None:
        """Run a function that ends what a request has begun that was not dropped, in any case."""
        self._put(command)

    def _put(self, command: Callable[[], None], begin: Callable[[], None] = lambda: None) -> None:
        self._waiting.put((command, begin))
        self._guard.trigger()

    def _drop(self, client: int) -> None:
        with self._lock:
            is_first = not self._dropped
            self._dropped[client] = self._dropped.get(client, 0) + 1
        if is_first:
            self._guard.trigger()

    # On the node's thread.

    def _run(self) -> None:
        for text in self._dropped_texts():
            self._say(text)
        for _ in range(self._waiting.qsize()):
            try:
                command, begin = self._waiting.get_nowait()
            except queue.Empty:
                return
            begin()
            try:
                command()
            except Exception as error:  # a client's request must not end the bridge
                self._say(f"A client's request failed: {type(error).__name__}: {error}")

    def _dropped_texts(self) -> list[str]:
        now_s = time.monotonic()
        with self._lock:
            if not self._dropped or now_s < self._next_dropped_s:
                return []
            dropped, self._dropped = self._dropped, {}
            self._next_dropped_s = now_s + DROPPED_S
        return [
            f"client {client} sends more than can be done: {count} of its messages and requests are dropped"
            for client, count in dropped.items()
        ]
