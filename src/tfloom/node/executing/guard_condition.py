"""Guard conditions: callbacks that the program triggers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom.node.executing.entity import CallbackEntity

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["GuardCondition"]


class GuardCondition(CallbackEntity):
    """Makes the executor run a callback at least once after each `trigger`."""

    _kind = "guard condition"

    def __init__(
        self,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None,
        context: Context | None = None,  # shutdown wakes executors without it
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self._triggered = False

    def trigger(self) -> None:
        """Make the executor run the callback. Threads and signal handlers may call this.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        self._triggered = True
        self._post()

    def trigger_guard_condition(self) -> None:
        """Call `trigger`; rclpy's C handle has this name."""
        self.trigger()

    def becomes_ready(self) -> bool:
        """Return True once after any number of triggers, for a wait set."""
        return self.take() is not None

    def destroy(self) -> None:
        """Stop triggering. The node no longer has it then."""
        self._end()

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` at each trigger."""
        self._queue, self._token = queue, token
        if self._triggered:
            queue.post(token)

    def take(self) -> Any:
        """Return True once after any number of triggers."""
        triggered, self._triggered = self._triggered, False
        return triggered or None
