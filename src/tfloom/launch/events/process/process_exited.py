"""The end of a process."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.running_process_event import RunningProcessEvent

__all__ = ["ProcessExited"]


class ProcessExited(RunningProcessEvent):
    """A process has ended.

    Args:
        returncode: Its exit code; minus a signal's number if that ended it.
        kwargs: As for RunningProcessEvent.
    """

    name = "launch.events.process.ProcessExited"

    def __init__(self, *, returncode: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._returncode = returncode

    @property
    def returncode(self) -> int:
        """Exit code; minus a signal's number if that ended the process."""
        return self._returncode
