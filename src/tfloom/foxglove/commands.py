"""Requests of clients, which arrive on threads of the SDK, for the thread of the node."""

from __future__ import annotations

import queue
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["Commands"]

MAX_COMMANDS = 10_000
"""Number of commands that wait; further ones are dropped."""


class Commands:
    """Runs functions on the node's thread, in the order in which they were put.

    Args:
        node: The node, whose executor runs them. An error of one of them is logged, and the others run.
    """

    def __init__(self, node: Node) -> None:
        self._node = node
        self._waiting: queue.Queue[Callable[[], None]] = queue.Queue(MAX_COMMANDS)
        self._guard = node.create_guard_condition(self._run)

    def put(self, command: Callable[[], None]) -> None:
        """Run a function soon; on any thread. Never waits."""
        try:
            self._waiting.put_nowait(command)
        except queue.Full:
            self._node.get_logger().warning(
                "Clients send more than can be done: some of it is dropped", throttle_duration_sec=5.0
            )
            return
        self._guard.trigger()

    def _run(self) -> None:
        for _ in range(self._waiting.qsize()):
            try:
                command = self._waiting.get_nowait()
            except queue.Empty:
                return
            try:
                command()
            except Exception as error:  # a client's request must not end the bridge
                self._node.get_logger().error(f"A client's request failed: {type(error).__name__}: {error}")
