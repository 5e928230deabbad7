"""Events of a launch itself: its end, a description that is added to it, and the end of a timer's period."""

from __future__ import annotations

from tfloom.launch.core.event import Event
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.launch_description import LaunchDescription

__all__ = ["IncludeLaunchDescription", "Shutdown", "TimerEvent"]


class Shutdown(Event):
    """Ends the launch: all its processes are to end.

    Args:
        reason: Why, for people.
        due_to_sigint: Whether Ctrl-C was pressed.
    """

    name = "launch.events.Shutdown"

    def __init__(self, *, reason: str = "reason not given", due_to_sigint: bool = False) -> None:
        self._reason = reason
        self._due_to_sigint = due_to_sigint

    @property
    def reason(self) -> str:
        """Why the launch is to end, as its log says it."""
        return self._reason

    @property
    def due_to_sigint(self) -> bool:
        """Whether Ctrl-C was pressed."""
        return self._due_to_sigint


class IncludeLaunchDescription(Event):
    """Adds a description to the launch.

    Args:
        launch_description: The description.
    """

    name = "launch.events.IncludeLaunchDescription"

    def __init__(self, launch_description: LaunchDescription) -> None:
        self._launch_description = launch_description

    @property
    def launch_description(self) -> LaunchDescription:
        """Description that is added to the launch."""
        return self._launch_description


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
