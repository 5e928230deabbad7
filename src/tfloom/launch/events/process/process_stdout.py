"""Output of a process."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.process_io import ProcessIO

__all__ = ["ProcessStdout"]


class ProcessStdout(ProcessIO):
    """A process has written to its stdout.

    Args:
        text: The octets.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessStdout"

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=1, **kwargs)
