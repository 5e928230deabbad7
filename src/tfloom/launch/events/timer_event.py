"""The end of a timer's period."""

from __future__ import annotations

from tfloom.launch.core.event import Event
from tfloom.launch.entities.action import Action

__all__ = ["TimerEvent"]


class TimerEvent(Event):
    """A timer's period is over.

    Args:
        timer_action: The timer, a TimerAction.
    """

    name = "launch.events.TimerEvent"

    def __init__(self, *, timer_action: Action) -> None:
        self._timer_action = timer_action

    @property
    def timer_action(self) -> Action:
        """The timer, a TimerAction."""
        return self._timer_action
