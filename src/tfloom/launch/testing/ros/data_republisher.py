"""Messages of one topic, changed and published on another."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.node.node import Node

__all__ = ["DataRepublisher"]

_DEPTH = 10


class DataRepublisher:
    """Publishes each message of a topic on another, as a function returns it.

    Args:
        node: Has the publisher and the subscription; something has to spin it.
        listen_topic: Topic of the messages.
        publish_topic: Topic of the changed ones.
        msg_type: Class of both.
        transform_fn: Takes a message and returns one, or None to drop it; called on the thread that spins the node.
    """

    def __init__(
        self,
        node: Node,
        listen_topic: str,
        publish_topic: str,
        msg_type: type[Any],
        transform_fn: Callable[[Any], Any],
    ) -> None:
        self._node = node
        self._transform = transform_fn
        self._num_received = 0
        self._republished: list[Any] = []
        self._publisher = node.create_publisher(msg_type, publish_topic, _DEPTH)
        self._subscription = node.create_subscription(msg_type, listen_topic, self._receive, _DEPTH)

    def shutdown(self) -> None:
        """End it, with its publisher and its subscription."""
        self._node.destroy_subscription(self._subscription)
        self._node.destroy_publisher(self._publisher)

    def get_num_received(self) -> int:
        """Return the number of messages that have come."""
        return self._num_received

    def get_num_republished(self) -> int:
        """Return the number of messages that were published, without those that were dropped."""
        return len(self._republished)

    def get_republished(self) -> list[Any]:
        """Return the messages that were published."""
        return list(self._republished)

    def _receive(self, message: Any) -> None:
        self._num_received += 1
        changed = self._transform(message)
        if changed:
            self._publisher.publish(changed)
            self._republished.append(changed)
