"""Input for some processes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent

__all__ = ["ProcessStdin"]


class ProcessStdin(ProcessTargetedEvent):
    """Writes to the stdin of processes.

    Args:
        text: What is written, as octets or text.
        process_matcher: Returns whether it is written to the process of an action.
    """

    name = "launch.events.process.ProcessStdin"

    def __init__(self, *, text: bytes | str, process_matcher: Callable[[Any], bool]) -> None:
        super().__init__(process_matcher=process_matcher)
        self._text = text.encode() if isinstance(text, str) else text

    @property
    def text(self) -> bytes:
        """The octets."""
        return self._text
