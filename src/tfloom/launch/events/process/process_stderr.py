"""Error output of a process."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.process_io import ProcessIO

__all__ = ["ProcessStderr"]


class ProcessStderr(ProcessIO):
    """A process has written to its stderr.

    Args:
        text: The octets.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStderr"

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=2, **kwargs)
