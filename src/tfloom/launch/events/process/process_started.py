"""The start of a process."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.running_process_event import RunningProcessEvent

__all__ = ["ProcessStarted"]


class ProcessStarted(RunningProcessEvent):
    """A process has started.

    Args:
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStarted"

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
