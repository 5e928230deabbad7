"""DiagnosticStatus with convenience methods: diagnostic_updater's DiagnosticStatusWrapper."""

from __future__ import annotations

from typing import Any, overload

from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticStatus, KeyValue

__all__ = ["DiagnosticStatus", "DiagnosticStatusWrapper", "KeyValue"]


class DiagnosticStatusWrapper(DiagnosticStatus):
    """DiagnosticStatus whose summary can be set and merged. Takes the message's fields by keyword."""

    @overload
    def summary(self, status: DiagnosticStatus, /) -> None: ...
    @overload
    def summary(self, lvl: bytes, msg: str, /) -> None: ...
    def summary(self, *args: Any) -> None:
        """Set level and message, given as two arguments or as those of another status."""
        self.level, self.message = _level_and_message(args)

    def clearSummary(self) -> None:
        """Set the level OK and an empty message."""
        self.summary(DiagnosticStatus.OK, "")

    @overload
    def mergeSummary(self, status: DiagnosticStatus, /) -> None: ...
    @overload
    def mergeSummary(self, lvl: bytes, msg: str, /) -> None: ...
    def mergeSummary(self, *args: Any) -> None:
        """Merge level and message, given as two arguments or as those of another status, into this status.

        The higher level wins. Messages of two levels that are both OK, or both not, are joined by `; `; else the
        message of the one that is not OK stays.
        """
        level, message = _level_and_message(args)
        if (level > DiagnosticStatus.OK) == (self.level > DiagnosticStatus.OK):
            self.message = f"{self.message}; {message}" if self.message else message
        elif level > self.level:
            self.message = message
        self.level = max(level, self.level)

    def add(self, key: str, val: object) -> None:
        """Append a value, as text, under a key."""
        self.values.append(KeyValue(key=key, value=str(val)))


def _level_and_message(arguments: tuple[Any, ...]) -> tuple[bytes, str]:
    match arguments:
        case (status,) if hasattr(status, "level") and hasattr(status, "message"):
            return status.level, status.message
        case (int() as level, message) if level in range(256):
            return bytes([level]), str(message)
        case (bytes() as level, message) if len(level) == 1:
            return level, str(message)
    raise TypeError(
        f"a summary is a DiagnosticStatus, or a level such as DiagnosticStatus.WARN and a message, not {arguments}"
    )
