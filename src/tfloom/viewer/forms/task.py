"""What is under way for a page, and its simplest kind: a type that is searched for."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.rmw.base import Writer
    from tfloom.rmw.shared.peer_types import TypeSearch

__all__ = ["Learning", "Task"]


class Task(ABC):
    """Something that takes a while, in steps. One thread may use it."""

    @property
    def due_s(self) -> float:
        """When there is something to do at the latest, if nothing arrives before [s, monotonic]; inf: never."""
        return math.inf

    @property
    def last_word(self) -> tuple[str, str]:
        """What a page is told when it has ended this: a state (`done` or `error`), and a text."""
        return "error", "it was given up"

    def uses(self, writer: Writer) -> bool:
        """Return whether it will still write with a writer."""
        return False

    @abstractmethod
    def step(self) -> bool:
        """Do what can be done now; return whether it is over.

        Raises:
            PageError, ServiceRequestError: it has failed.
        """

    def cancel(self) -> bool:
        """Begin to end it; return whether it is over, as it is where nobody has to be told."""
        return True

    @abstractmethod
    def close(self) -> None:
        """Close what it has opened."""


class Learning(Task):
    """A type that is searched for among the nodes that use it.

    Args:
        search: The search.
        tell: Called when it is over, with the reasons why the descriptions of nodes can't be used.
    """

    def __init__(self, search: TypeSearch, tell: Callable[[list[str]], None]) -> None:
        self._search = search
        self._tell = tell

    def step(self) -> bool:
        """Search on; return whether the search is over."""
        if not self._search.step():
            return False
        self._tell(self._search.reasons)
        return True

    def close(self) -> None:
        """Leave the node that is asked."""
        self._search.close()
