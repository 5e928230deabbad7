"""Waitables on an executor that builds no wait set: what one waits for posts the waitable's own token."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.node.executing.entity import Entity
from tfloom.node.values.handle import thing_of

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.node.executing.executor import Executor
    from tfloom.node.executing.waitable import Waitable

__all__ = ["KINDS", "WaitSet", "WaitableEntity", "Waited"]

KINDS = ("subscription", "guard_condition", "timer", "client", "service", "event")


class Waited(Protocol):
    """One thing in a wait set."""

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when `becomes_ready` may be true, at once if it is already."""

    def detach(self) -> None:
        """Post no more."""

    def becomes_ready(self) -> bool:
        """Return whether there is something to take. Where nothing is ever taken, asking takes it."""

    def deadline_ns(self) -> int | None:
        """Return when to ask next, by `time.monotonic_ns`; None while only a post can tell."""


class WaitSet:
    """What one waitable waits for, in order of each kind, and what of it is ready."""

    def __init__(self) -> None:
        self._waited: dict[str, list[Waited]] = {kind: [] for kind in KINDS}
        self._ready: dict[str, set[int]] = {kind: set() for kind in KINDS}

    def _add(self, kind: str, waited: Waited) -> int:
        if not hasattr(waited, "becomes_ready"):
            raise TypeError(
                f"a wait set can't wait for {waited!r}: give it a {kind} of "
                "rclpy.impl.implementation_singleton.rclpy_implementation"
            )
        self._waited[kind].append(thing_of(waited))
        return len(self._waited[kind]) - 1

    def add_subscription(self, subscription: Waited) -> int:
        """Wait for messages; the index is for `is_ready`, here as below."""
        return self._add("subscription", subscription)

    def add_guard_condition(self, guard_condition: Waited) -> int:
        """Wait for a trigger."""
        return self._add("guard_condition", guard_condition)

    def add_timer(self, timer: Waited) -> int:
        """Wait for a period's end."""
        return self._add("timer", timer)

    def add_client(self, client: Waited) -> int:
        """Wait for responses."""
        return self._add("client", client)

    def add_service(self, service: Waited) -> int:
        """Wait for requests."""
        return self._add("service", service)

    def add_event(self, event: Waited) -> int:
        """Wait for an event of a publisher or subscription."""
        return self._add("event", event)

    def is_ready(self, entity_type: str, index: int | None) -> bool:
        """Return whether something was ready after the last wait.

        Args:
            entity_type: One of `KINDS`.
            index: What `add_…` returned.

        Raises:
            ValueError: there is no such kind.
            IndexError: that many of it weren't added.
        """
        if entity_type not in self._waited:
            raise ValueError(f"'{entity_type}' is no kind of entity; known are {', '.join(KINDS)}")
        if index is None or not 0 <= index < len(self._waited[entity_type]):
            raise IndexError(f"there is no {entity_type} {index} in the wait set")
        return index in self._ready[entity_type]

    def get_ready_entities(self, entity_type: str) -> list[Waited]:
        """Return what of a kind was ready after the last wait."""
        waited = self._waited[entity_type]
        return [waited[index] for index in sorted(self._ready[entity_type])]

    def everything(self) -> list[Waited]:
        """Return all that is waited for."""
        return [each for kind in KINDS for each in self._waited[kind]]

    def look(self) -> None:
        """Find out what is ready now."""
        self._ready = {
            kind: {index for index, each in enumerate(waited) if each.becomes_ready()}
            for kind, waited in self._waited.items()
        }


class WaitableEntity(Entity):
    """A waitable as an executor runs it: looked at when what it waits for posts, or anything wakes the executor."""

    is_timed = True
    is_polled = True

    def __init__(self, waitable: Waitable, executor: Callable[[], Executor | None]) -> None:
        self.waitable = waitable
        self._executor = executor
        self.callback_group = waitable.callback_group
        self._queue: ReadyQueue | None = None
        self._token = 0
        self._wait_set = WaitSet()

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Build the wait set, and have all in it post `token`."""
        self._queue, self._token = queue, token
        self._arm()
        queue.post(token)  # it may be ready by itself

    def detach(self) -> None:
        """Post no more."""
        self._queue = None
        for each in self._wait_set.everything():
            each.detach()

    def _arm(self) -> None:
        queue = self._queue
        if queue is None:
            return
        before = self._wait_set.everything()
        self._wait_set = WaitSet()
        self.waitable.add_to_wait_set(self._wait_set)
        now = self._wait_set.everything()
        for each in before:
            if not any(each is other for other in now):
                each.detach()
        for each in now:
            if not any(each is other for other in before):
                each.attach(queue, self._token)

    def take(self) -> Any:
        """Return what the waitable has taken, in a tuple, if it says that it is ready."""
        if self._queue is None:
            return None
        self._wait_set.look()
        try:
            if not self.waitable.is_ready(self._wait_set):
                return None
            taken = (self.waitable.take_data(),)
        finally:
            self._arm()
        if self._queue is not None:
            self._queue.post(self._token)  # there may be more
        return taken

    def deadline_ns(self) -> int | None:
        """Return when the first of its timers is due."""
        ends = [end for each in self._wait_set.everything() if (end := each.deadline_ns()) is not None]
        return min(ends, default=None)

    def run(self, taken: Any) -> Any:
        """Execute what was taken; the coroutine is the executor's to go on with."""
        for future in self.waitable._futures:  # noqa: SLF001  # Waitable's own
            future.set_executor(self._executor())
        return self.waitable.execute(*taken)

    def destroy(self) -> None:
        """Wait for nothing any more. The waitable, and what it waits for, are the program's."""
        self.detach()
