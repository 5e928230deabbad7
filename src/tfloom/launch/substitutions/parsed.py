"""The base class of substitutions whose arguments in launch files are those of their constructors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from tfloom.launch.core.substitution import SomeSubstitutionsType, Substitution

__all__ = ["ParsedSubstitution"]


class ParsedSubstitution(Substitution):
    """A substitution whose arguments in launch files, `$(name argument …)`, are its constructor's, in order."""

    _arguments: ClassVar[tuple[str, ...]] = ()
    """Names that the constructor has for them."""
    _optional: ClassVar[int] = 0
    """How many of them, at the end, may be missing."""
    _fault: ClassVar[str]
    """Text of the error of another number of them."""
    _error: ClassVar[type[Exception]] = TypeError
    """Class of this error."""

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Return the class, and the arguments that the text of a launch file gives its constructor.

        Raises:
            TypeError, ValueError, AttributeError: there are too few or too many; the class defines which it is.
        """
        if not len(cls._arguments) - cls._optional <= len(data) <= len(cls._arguments):
            raise cls._error(cls._fault.format(class_name=cls.__name__, count=len(data)))
        return cls, dict(zip(cls._arguments, data, strict=False))
