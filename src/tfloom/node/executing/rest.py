"""What remains of a node in an executor that it has left, so that its return is quick."""

from __future__ import annotations

import threading
import weakref
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from tfloom.node.executing.entity import Entity

__all__ = ["Rest"]


class Registry(Protocol):
    """The method of an executor that a return calls."""

    def register(self, rest: Rest) -> None:
        """Add entities that post already."""


class Rest:
    """The entities of a node that has left an executor; while it rests, they post their tokens to its queue.

    `rclpy.spin_once` and `spin_until_future_complete` add their node and remove it each time. With a rest, neither
    calls an entity. The node holds it, and the executor only a weak reference, so an unused node is freed.

    Args:
        queue: The executor that the node leaves.
        tokens: The token of each of the node's entities there.
    """

    def __init__(self, queue: Registry, tokens: dict[Entity, int]) -> None:
        self._queue = weakref.ref(queue)
        self._lock = threading.Lock()
        """Guards `is_resting`, and the entities' attachment while it is True."""
        self.tokens = tokens
        self.entities = list(tokens)
        self.by_token = {token: entity for entity, token in tokens.items()}
        self.is_resting = False
        """Whether the entities post, and are not in the queue."""

    def end(self) -> None:
        """Make the entities stop posting, unless the node has returned."""
        with self._lock:
            if self.is_resting:
                self.is_resting = False
                for entity in self.entities:
                    entity.detach()

    def end_by_return(self, queue: Registry, entities: list[Entity]) -> bool:
        """Register the entities in a queue again; return False if they have to be added anew.

        That is if the rest has ended, for another queue, and if the node has other entities than it had.
        """
        if self._queue() is not queue or self.entities != entities:
            self.end()
            return False
        with self._lock:
            if not self.is_resting:
                return False
            queue.register(self)
            self.is_resting = False
            return True
