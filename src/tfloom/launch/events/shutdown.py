"""The end of a launch."""

from __future__ import annotations

from tfloom.launch.core.event import Event

__all__ = ["Shutdown"]


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
