"""Requests of clients, which arrive on threads of the SDK, for the thread of the node."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["Commands"]

MAX_MESSAGES = 10_000
"""Number of messages that wait; further ones are dropped."""
MAX_BYTES = 100_000_000
"""Sum of their sizes; when it is reached, further ones are dropped."""


class Commands:
    """Runs functions on the node's thread, in the order in which they were put.

    Args:
        node: The node, whose executor runs them. An error of one of them is logged, and the others run.
    """

    def __init__(self, node: Node) -> None:
        self._node = node
        self._waiting: queue.SimpleQueue[tuple[Callable[[], None], int | None]] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._messages = self._bytes = 0
        """Number and sizes of the messages that wait; guarded by `_lock`."""
        self._guard = node.create_guard_condition(self._run)

    def put(self, command: Callable[[], None], message_size: int | None = None) -> None:
        """Run a function soon; on any thread. Never waits.

        Args:
            command: The function.
            message_size: If it is for a message, its size: of messages, those beyond a limit are dropped. All else is
                done, because a client that sends too much must not keep others from what they ask for once.
        """
        if message_size is not None and not self._count(message_size):
            self._node.get_logger().warning(
                "Clients send more than can be done: some of it is dropped", throttle_duration_sec=5.0
            )
            return
        self._waiting.put((command, message_size))
        self._guard.trigger()

    def _count(self, size: int) -> bool:
        """Count a message; return False if too many wait."""
        with self._lock:
            if self._messages >= MAX_MESSAGES or self._bytes >= MAX_BYTES:
                return False
            self._messages += 1
            self._bytes += size
            return True

    def _run(self) -> None:
        for _ in range(self._waiting.qsize()):
            try:
                command, message_size = self._waiting.get_nowait()
            except queue.Empty:
                return
            if message_size is not None:
                with self._lock:
                    self._messages -= 1
                    self._bytes -= message_size
            try:
                command()
            except Exception as error:  # a client's request must not end the bridge
                self._node.get_logger().error(f"A client's request failed: {type(error).__name__}: {error}")
