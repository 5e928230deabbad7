"""The types that a program's endpoints give a topic."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from tfloom.rmw.base import Topic

__all__ = ["TopicTypes"]


class TopicEndpoint(Protocol):
    """A publisher or a subscription."""

    @property
    def is_destroyed(self) -> bool:
        """Whether it has left the wire."""


class TopicTypes:
    """The type of each topic by the first endpoint that a program has of it, while that one lives.

    Endpoints may be added from any thread: each change is a single operation on a dict.
    """

    def __init__(self) -> None:
        self._first: dict[str, tuple[weakref.ref[TopicEndpoint], Topic]] = {}

    def add(self, topic: Topic, endpoint: TopicEndpoint) -> str | None:
        """Add an endpoint; return the type of the topic's first one if it is another, else None."""
        reference, first_topic = self._first.get(topic.name, (None, topic))
        first = None if reference is None else reference()
        if first is None or first.is_destroyed:
            self._first[topic.name] = weakref.ref(endpoint), topic
            return None
        return first_topic.type_name if first_topic.type_name != topic.type_name else None
