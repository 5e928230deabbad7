"""The entity by which an executor runs a waitable."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom.node.executing.entity import Entity
from tfloom.node.executing.wait_set import WaitSet

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.node.executing.task import TaskRunner
    from tfloom.node.executing.waitable import Waitable

__all__ = ["WaitableEntity"]


class WaitableEntity(Entity):
    """A waitable as an entity, checked when an item of its wait set posts, and whenever the executor wakes."""

    is_timed = True
    is_polled = True

    def __init__(self, waitable: Waitable, executor: Callable[[], TaskRunner | None]) -> None:
        self.waitable = waitable
        self._executor = executor
        self.callback_group = waitable.callback_group
        self._queue: ReadyQueue | None = None
        self._token = 0
        self._wait_set = WaitSet()
        self.stands_for = waitable
        self._is_ready = False
        """Whether it was found to be ready, and its data were not taken yet."""

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Build the wait set, and make all its items post `token`."""
        self._queue, self._token = queue, token
        self._rebuild_wait_set()
        queue.post(token)  # it may be ready without a post

    def detach(self) -> None:
        """Stop posting the token."""
        self._queue = None
        for item in self._wait_set.everything():
            item.detach()

    def _rebuild_wait_set(self) -> None:
        queue = self._queue
        if queue is None:
            return
        former_items = self._wait_set.everything()
        wait_set = WaitSet()
        self.waitable.add_to_wait_set(wait_set)  # if it raises, the items of the last call go on posting
        self._wait_set = wait_set
        items = wait_set.everything()
        for item in former_items:
            if not any(item is other for other in items):
                item.detach()
        for item in items:
            if not any(item is other for other in former_items):
                item.attach(queue, self._token)

    def has_next(self) -> bool:
        """Return whether the waitable is ready."""
        if not self._is_ready and self._queue is not None:
            self._wait_set.update()
            try:
                self._is_ready = bool(self.waitable.is_ready(self._wait_set))
            finally:
                # The waitable may wait for other items from now on, so it is asked after each check.
                if not self._is_ready:
                    self._rebuild_wait_set()
        return self._is_ready

    def take(self) -> Any:
        """Return the data of the waitable, in a tuple, if it is ready."""
        if self._queue is None or not self.has_next():
            return None
        self._is_ready = False
        try:
            taken = (self.waitable.take_data(),)
        finally:
            self._rebuild_wait_set()  # as in `has_next`
        if self._queue is not None:
            self._queue.post(self._token)  # there may be more
        return taken

    def deadline_ns(self) -> int | None:
        """Return the earliest deadline of its timers."""
        deadlines_ns = [
            deadline_ns
            for item in self._wait_set.everything()
            if (deadline_ns := item.deadline_ns()) is not None
        ]
        return min(deadlines_ns, default=None)

    def run(self, taken: Any) -> Any:
        """Execute the data; the executor runs the coroutine."""
        for future in self.waitable._futures:  # by rclpy's name, which programs append to
            future.set_executor(self._executor())
        return self.waitable.execute(*taken)

    def destroy(self) -> None:
        """Stop waiting. The program owns the waitable and its items."""
        self.detach()
