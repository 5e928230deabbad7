"""The start of a process."""

from __future__ import annotations

from tfloom.launch.events.process.running_process_event import RunningProcessEvent

__all__ = ["ProcessStarted"]


class ProcessStarted(RunningProcessEvent):
    """A process has started."""

    name = "launch.events.process.ProcessStarted"
