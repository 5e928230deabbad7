"""The base class of substitutions of two values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described

__all__ = ["TwoValues"]


class TwoValues(Substitution):
    """A text that two values decide, as derived classes define.

    Args:
        left: First value.
        right: Second value.
    """

    _word: str
    """Name of the substitution in launch files."""

    def __init__(self, left: list[Substitution], right: list[Substitution]) -> None:
        super().__init__()
        self._left = left
        self._right = right

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[TwoValues], dict[str, Any]]:
        """Return the class and the arguments of `$(name left right)`.

        Raises:
            TypeError: there are not exactly two arguments.
        """
        if len(data) != 2:
            raise TypeError(f"{cls._word} substitution expects 2 arguments")
        return cls, {"left": data[0], "right": data[1]}

    @property
    def left(self) -> list[Substitution]:
        """First value."""
        return self._left

    @property
    def right(self) -> list[Substitution]:
        """Second value."""
        return self._right

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}({described(self._left)} {described(self._right)})"
