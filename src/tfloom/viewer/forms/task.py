"""What is under way for a page."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

__all__ = ["Task"]


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
