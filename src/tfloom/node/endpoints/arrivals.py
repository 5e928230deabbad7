"""Functions of the program that are told of arriving data, as by `set_on_new_message_callback` of rclpy's handles."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom._native import ReadyQueue
from tfloom.node.values.callback_errors import report_exception
from tfloom.node.values.exceptions import RCLError

if TYPE_CHECKING:
    from tfloom.node.endpoints.queue_switch import QueueSwitch

__all__ = ["Arrivals"]

_ARRIVED = 1


class Arrivals:
    """Calls a function with the number of items that have arrived, on a thread of its own, until `end`.

    The thread takes them from the wire, because only that tells their number; executors and waiting calls find them
    where the endpoint keeps them, and are woken.

    Args:
        switch: Of the endpoint.
        collect: Moves what has arrived from the wire to where the endpoint keeps it, and returns how many there were.
        kept: How many items the endpoint keeps already.
        callback: Called with each number above 0.

    Raises:
        RCLError: a thread can't be started.
    """

    def __init__(
        self, switch: QueueSwitch, collect: Callable[[], int], kept: int, callback: Callable[[int], Any]
    ) -> None:
        self._switch = switch
        self._collect = collect
        self._kept = kept
        self._callback = callback
        self._queue = ReadyQueue()
        self._is_ended = False
        try:
            threading.Thread(target=self._run, daemon=True).start()
        except RuntimeError as error:
            raise RCLError(f"failed to set the callback of new data: {error}") from None
        switch.divert(self._queue, _ARRIVED)
        self._queue.post(_ARRIVED)  # for what is kept

    def end(self) -> None:
        """Call the function no more, but for a call that is under way."""
        self._is_ended = True
        self._switch.restore(self._queue)
        self._queue.post(_ARRIVED)

    def _run(self) -> None:
        while True:
            self._queue.wait(-1)
            if self._is_ended:
                return
            count = self._collect() + self._kept
            self._kept = 0
            if not count:
                continue
            self._switch.forward(self._queue)
            try:
                self._callback(count)
            except Exception:  # it ends this call alone
                report_exception()
