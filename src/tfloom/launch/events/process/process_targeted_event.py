"""The base class of the events that do something to a process."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.event import Event

__all__ = ["ProcessTargetedEvent"]


class ProcessTargetedEvent(Event):
    """Something is to be done to some of the processes.

    Args:
        process_matcher: Returns whether it is to be done to the process of an action.
    """

    name = "launch.events.process.ProcessTargetedEvent"

    def __init__(self, *, process_matcher: Callable[[Any], bool]) -> None:
        self._process_matcher = process_matcher

    @property
    def process_matcher(self) -> Callable[[Any], bool]:
        """Function that returns whether it is to be done to the process of an action."""
        return self._process_matcher
