"""Guard conditions: callbacks that the program triggers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom.node.executing.entity import Entity
from tfloom.node.values.exceptions import InvalidHandle
from tfloom.node.values.handle import Handle

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["GuardCondition"]


class GuardCondition(Entity):
    """Makes the executor run a callback at least once after each `trigger`."""

    def __init__(
        self,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None,
        context: Context | None = None,  # noqa: ARG002  # shutdown wakes executors without it
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self._triggered = False
        self._destroyed = False
        self._queue: ReadyQueue | None = None
        self._token = 0

    @property
    def handle(self) -> Handle:
        """Proxy of the guard condition, for code that expects rclpy's C handle.

        Raises:
            InvalidHandle: it was destroyed.
        """
        return Handle(self._alive(), self._alive)

    def _alive(self) -> Self:
        """Return this guard condition.

        Raises:
            InvalidHandle: it was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle("cannot use a guard condition that was destroyed")
        return self

    def trigger(self) -> None:
        """Make the executor run the callback. Threads and signal handlers may call this.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        self._triggered = True
        queue = self._queue
        if queue is not None:
            queue.post(self._token)

    def trigger_guard_condition(self) -> None:
        """Call `trigger`; rclpy's C handle has this name."""
        self.trigger()

    def becomes_ready(self) -> bool:
        """Return True once after any number of triggers, for a wait set."""
        return self.take() is not None

    def destroy(self) -> None:
        """Stop triggering."""
        self._destroyed = True
        self.detach()

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` at each trigger."""
        self._queue, self._token = queue, token
        if self._triggered:
            queue.post(token)

    def detach(self) -> None:
        """Stop posting the token."""
        self._queue = None

    def take(self) -> Any:
        """Return True once after any number of triggers."""
        triggered, self._triggered = self._triggered, False
        return triggered or None

    def run(self, taken: Any) -> Any:  # noqa: ARG002
        """Call the callback of the guard condition."""
        return None if self.callback is None else self.callback()
