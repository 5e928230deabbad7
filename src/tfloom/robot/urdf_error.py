"""The error of descriptions that are not valid."""

from __future__ import annotations

__all__ = ["UrdfError"]


class UrdfError(ValueError):
    """A text does not describe a robot.

    Attributes:
        line: Line of the text, from 1.
        reason: What is wrong.
    """

    def __init__(self, line: int, reason: str) -> None:
        super().__init__(f"line {line}: {reason}")
        self.line = line
        self.reason = reason
