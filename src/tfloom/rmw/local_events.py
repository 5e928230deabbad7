"""The events of the in-process wire: matched peers and incompatible ones."""

from __future__ import annotations

import threading

from tfloom._native import ReadyQueue
from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import Event, IncompatibleQoS, Matched, Status
from tfloom.rmw.qos import QoSPolicyKind

KNOWN = (Event.MATCHED, Event.INCOMPATIBLE_QOS)


class LocalEvents:
    """The statuses of one endpoint, and the queues to notify."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._listeners: dict[Event, tuple[ReadyQueue, int]] = {}
        self._matched = Matched(0, 0, 0, 0)
        self._incompatible = IncompatibleQoS(0, 0, QoSPolicyKind.INVALID)

    def add_match(self, change: int) -> None:
        """Count a peer that has matched (1) or left (-1)."""
        with self._lock:
            was = self._matched
            new = max(change, 0)
            self._matched = Matched(
                was.total_count + new,
                was.total_count_change + new,
                was.current_count + change,
                was.current_count_change + change,
            )
            self._post(Event.MATCHED)

    def add_incompatible(self, kind: QoSPolicyKind) -> None:
        """Count an incompatible peer."""
        with self._lock:
            was = self._incompatible
            self._incompatible = IncompatibleQoS(was.total_count + 1, was.total_count_change + 1, kind)
            self._post(Event.INCOMPATIBLE_QOS)

    def _post(self, event: Event) -> None:
        if listener := self._listeners.get(event):
            listener[0].post(listener[1])

    def notify(self, event: Event, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when the event has a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: the event isn't one of `KNOWN`.
        """
        _check(event)
        with self._lock:
            if queue is None:
                self._listeners.pop(event, None)
            else:
                self._listeners[event] = (queue, token)
                queue.post(token)

    def take(self, event: Event) -> Status | None:
        """Return what has changed since the last call, or None.

        Raises:
            UnsupportedEventError: the event isn't one of `KNOWN`.
        """
        _check(event)
        with self._lock:
            if event == Event.MATCHED:
                matched = self._matched
                self._matched = matched._replace(total_count_change=0, current_count_change=0)
                return matched if matched.total_count_change or matched.current_count_change else None
            incompatible = self._incompatible
            self._incompatible = incompatible._replace(total_count_change=0)
            return incompatible if incompatible.total_count_change else None


def _check(event: Event) -> None:
    if event not in KNOWN:
        names = " and ".join(event_kind.name for event_kind in KNOWN)
        raise UnsupportedEventError(f"{event.name}: the in-process wire has {names} alone")
