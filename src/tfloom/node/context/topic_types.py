"""The types that a program's endpoints give a topic."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Protocol
from weakref import WeakSet

if TYPE_CHECKING:
    from tfloom.rmw.base import Topic

__all__ = ["TopicTypes"]


class TopicEndpoint(Protocol):
    """A publisher or a subscription."""

    msg_type: type[Any]
    event_handlers: list[Any]

    @property
    def is_destroyed(self) -> bool:
        """Whether it has left the wire."""


class TopicTypes:
    """The publishers and subscriptions of a program, by topic and type. Any thread may add one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        """Guards `_endpoints`."""
        self._endpoints: dict[str, dict[str, WeakSet[TopicEndpoint]]] = {}

    def add(self, topic: Topic, endpoint: TopicEndpoint) -> list[TopicEndpoint]:
        """Add an endpoint, and return those that use its topic with another type."""
        with self._lock:
            by_type = self._endpoints.setdefault(topic.name, {})
            others = [
                other
                for type_name, endpoints in by_type.items()
                if type_name != topic.type_name
                for other in endpoints
                if not other.is_destroyed
            ]
            by_type.setdefault(topic.type_name, WeakSet()).add(endpoint)
        return others
