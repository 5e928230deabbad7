"""Input and output of a process."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.running_process_event import RunningProcessEvent

__all__ = ["ProcessIO"]


class ProcessIO(RunningProcessEvent):
    """A process has read or written something.

    Args:
        text: The octets.
        fd: The process's descriptor: 0 stdin, 1 stdout, 2 stderr.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessIO"

    def __init__(self, *, text: bytes, fd: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._text = text
        self._fd = fd

    @property
    def text(self) -> bytes:
        """The octets."""
        return self._text

    @property
    def from_stdin(self) -> bool:
        """Whether they went to the process's stdin."""
        return self._fd == 0

    @property
    def from_stdout(self) -> bool:
        """Whether they came from the process's stdout."""
        return self._fd == 1

    @property
    def from_stderr(self) -> bool:
        """Whether they came from the process's stderr."""
        return self._fd == 2
