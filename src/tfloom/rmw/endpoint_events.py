"""The events of one writer or reader on a wire whose library counts none: their statuses, and the queues to notify."""

from __future__ import annotations

import threading
from typing import Any

from tfloom._native import ReadyQueue
from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import AT_FIRST, Event, Status
from tfloom.rmw.qos import QoSPolicyKind

__all__ = ["MATCH_EVENTS", "READER_EVENTS", "WRITER_EVENTS", "EndpointEvents"]

MATCH_EVENTS = (Event.MATCHED, Event.INCOMPATIBLE_QOS)
"""The events that follow from discovery alone."""
WRITER_EVENTS = (*MATCH_EVENTS, Event.DEADLINE_MISSED, Event.LIVELINESS_LOST)
READER_EVENTS = (*MATCH_EVENTS, Event.DEADLINE_MISSED, Event.LIVELINESS_CHANGED, Event.MESSAGE_LOST)
MAX_COUNT = 0x7FFF_FFFF
"""The largest number of a status: ROS has 32 bits for it."""


class EndpointEvents:
    """The statuses, by event. All methods may be called from any thread.

    Args:
        known: The events that this endpoint has.
        refusal: Why it has no other, for the error.
    """

    def __init__(self, known: tuple[Event, ...], refusal: str) -> None:
        self._refusal = refusal
        self._lock = threading.Lock()
        self._statuses: dict[Event, Any] = {event: AT_FIRST[event] for event in known}
        self._listeners: dict[Event, tuple[ReadyQueue, int]] = {}
        self._matched_count = 0

    def invalidate_after_fork(self) -> None:
        """Replace the lock, which a thread of the parent may have held."""
        self._lock = threading.Lock()

    def matched_count(self) -> int:
        """Return how many compatible peers are connected now."""
        return self._matched_count

    def add_match(self, change: int) -> None:
        """Count a peer that has matched (1) or left (-1)."""
        with self._lock:
            self._matched_count += change
            self._add(Event.MATCHED, total_count=max(change, 0), current_count=change)

    def add_incompatible(self, kind: QoSPolicyKind) -> None:
        """Count a peer of an incompatible quality of service, and note the policy."""
        with self._lock:
            status = self._statuses[Event.INCOMPATIBLE_QOS]
            self._statuses[Event.INCOMPATIBLE_QOS] = status._replace(last_policy_kind=kind)
            self._add(Event.INCOMPATIBLE_QOS, total_count=1)

    def change_liveliness(self, alive: int, not_alive: int) -> None:
        """Add to the numbers of writers that are alive, and that aren't."""
        with self._lock:
            self._add(Event.LIVELINESS_CHANGED, alive_count=alive, not_alive_count=not_alive)

    def count(self, event: Event, more: int = 1) -> None:
        """Count missed deadlines, lost liveliness or lost samples."""
        with self._lock:
            self._add(event, total_count=more)

    def _add(self, event: Event, **amounts: int) -> None:
        """Add to numbers of a status and to their changes, and notify; the caller holds the lock."""
        status = self._statuses[event]
        numbers = {
            field: min(getattr(status, field) + amount, MAX_COUNT)
            for name, amount in amounts.items()
            for field in (name, f"{name}_change")
        }
        self._statuses[event] = status._replace(**numbers)
        if listener := self._listeners.get(event):
            listener[0].post(listener[1])

    def notify(self, event: Event, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when the event has a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: the endpoint has no such event.
        """
        self._check(event)
        with self._lock:
            if queue is None:
                self._listeners.pop(event, None)
            else:
                self._listeners[event] = (queue, token)
                queue.post(token)

    def take(self, event: Event) -> Status | None:
        """Return the status of an event if it has changed since the last call, or None.

        Raises:
            UnsupportedEventError: the endpoint has no such event.
        """
        self._check(event)
        with self._lock:
            status: Status = self._statuses[event]
            changes = [field for field in status._fields if field.endswith("_change")]
            if not any(getattr(status, field) for field in changes):
                return None
            self._statuses[event] = self._statuses[event]._replace(**dict.fromkeys(changes, 0))
            return status

    def _check(self, event: Event) -> None:
        if event not in self._statuses:
            raise UnsupportedEventError(f"{event.name}: {self._refusal}")
