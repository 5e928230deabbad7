"""Input for some processes."""

from __future__ import annotations

from typing import Any

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent

__all__ = ["ProcessStdin"]


class ProcessStdin(ProcessTargetedEvent):
    """Writes to the stdin of processes.

    Args:
        text: What is written, as octets or text.
        kwargs: As for ProcessTargetedEvent.
    """

    name = "launch.events.process.ProcessStdin"

    def __init__(self, *, text: bytes | str, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._text = text.encode() if isinstance(text, str) else text

    @property
    def text(self) -> bytes:
        """The octets."""
        return self._text
