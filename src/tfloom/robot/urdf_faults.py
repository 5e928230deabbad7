"""What is wrong with a description: the error of one that can't be read, and remarks on one that is."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["Remark", "Remarks", "UrdfError"]


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


class Remark(NamedTuple):
    """A sentence on one place, or on several of one kind."""

    line: int
    """Line of the text, from 1; that of the first place."""
    text: str
    """What is wrong there."""
    is_refused: bool = False
    """Whether urdfdom, the parser of ROS's own programs, refuses the description for it."""

    def __str__(self) -> str:
        """Return the sentence with its line."""
        also = "; ROS's own programs refuse the description for it" if self.is_refused else ""
        return f"line {self.line}: {self.text}{also}"


class Remarks:
    """Collects remarks, one for each kind, because a file may have a fault on every line."""

    def __init__(self) -> None:
        self._by_kind: dict[str, tuple[Remark, int]] = {}

    def add(self, line: int, text: str, kind: str = "", *, is_refused: bool = False) -> None:
        """Add a remark, or count it, if there is one of its kind; without a kind, the text is the kind."""
        first, count = self._by_kind.get(kind or text, (Remark(line, text, is_refused), 0))
        self._by_kind[kind or text] = first, count + 1

    def collected(self) -> tuple[Remark, ...]:
        """Return the remarks in the order of their lines; one that stands for several places says how many."""
        return tuple(
            sorted(
                remark._replace(text=f"{remark.text} ({count - 1} more such places)") if count > 1 else remark
                for remark, count in self._by_kind.values()
            )
        )
