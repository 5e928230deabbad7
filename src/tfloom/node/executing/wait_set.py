"""Wait sets of waitables, whose items post the waitable's token to the executor."""

from __future__ import annotations

import time
from typing import Protocol

from tfloom._native import ReadyQueue
from tfloom.node.values.handle import unwrap_handle

__all__ = ["KINDS", "WaitSet", "Waited"]

KINDS = ("subscription", "guard_condition", "timer", "client", "service", "event")


class Waited(Protocol):
    """An item of a wait set."""

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when `becomes_ready` may be true, at once if it is."""

    def detach(self) -> None:
        """Stop posting the token."""

    def becomes_ready(self) -> bool:
        """Return whether there is something to take; for a guard condition, this also takes the trigger."""

    def deadline_ns(self) -> int | None:
        """Return the time of the next check, by `time.monotonic_ns`; None: after the next post."""


class WaitSet:
    """The items that one waitable, or a program itself, waits for, by kind, and which of them are ready.

    Args:
        sizes: Unused, because a wait set grows; kept for rclpy's signature: the numbers of items of each kind, and the
            context's handle.
    """

    def __init__(self, *sizes: object) -> None:
        self.clear_entities()

    def clear_entities(self) -> None:
        """Remove all items."""
        self._waited: dict[str, list[Waited]] = {kind: [] for kind in KINDS}
        self._ready: dict[str, set[int]] = {kind: set() for kind in KINDS}

    def _add(self, kind: str, waited: Waited) -> int:
        if not hasattr(waited, "becomes_ready"):
            raise TypeError(
                f"a wait set can't wait for {waited!r}: give it a {kind} of "
                "rclpy.impl.implementation_singleton.rclpy_implementation"
            )
        self._waited[kind].append(unwrap_handle(waited))
        return len(self._waited[kind]) - 1

    def add_subscription(self, subscription: Waited) -> int:
        """Wait for messages, and return the index for `is_ready`, as the methods below do."""
        return self._add("subscription", subscription)

    def add_guard_condition(self, guard_condition: Waited) -> int:
        """Wait for a trigger."""
        return self._add("guard_condition", guard_condition)

    def add_timer(self, timer: Waited) -> int:
        """Wait for the end of a period."""
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
        """Return whether an item was ready after the last wait.

        Args:
            entity_type: One of `KINDS`.
            index: The index that `add_…` returned.

        Raises:
            ValueError: there is no such kind.
            IndexError: no item of this kind has that index.
        """
        if entity_type not in self._waited:
            raise ValueError(f"'{entity_type}' is not a kind of entity; known are {', '.join(KINDS)}")
        if index is None or not 0 <= index < len(self._waited[entity_type]):
            raise IndexError(f"there is no {entity_type} {index} in the wait set")
        return index in self._ready[entity_type]

    def get_ready_entities(self, entity_type: str) -> list[Waited]:
        """Return the items of a kind that were ready after the last wait."""
        waited = self._waited[entity_type]
        return [waited[index] for index in sorted(self._ready[entity_type])]

    def everything(self) -> list[Waited]:
        """Return the items of all kinds."""
        return [item for kind in KINDS for item in self._waited[kind]]

    def wait(self, timeout_nsec: int) -> None:
        """Wait until an item is ready; a program that has its own wait set calls this.

        Args:
            timeout_nsec: The longest wait [ns]; negative: no limit.
        """
        end_ns = None if timeout_nsec < 0 else time.monotonic_ns() + timeout_nsec
        queue = ReadyQueue()
        items = self.everything()
        for item in items:
            item.attach(queue, 1)
        try:
            while True:
                self.update()
                if any(self._ready.values()):
                    return
                ends_ns = [
                    end for end in (end_ns, *(item.deadline_ns() for item in items)) if end is not None
                ]
                if end_ns is not None and time.monotonic_ns() >= end_ns:
                    return
                queue.wait(max(0, min(ends_ns) - time.monotonic_ns()) if ends_ns else -1)
        finally:
            for item in items:
                item.detach()

    def update(self) -> None:
        """Update which items are ready."""
        self._ready = {
            kind: {index for index, item in enumerate(waited) if item.becomes_ready()}
            for kind, waited in self._waited.items()
        }
