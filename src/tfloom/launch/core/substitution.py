"""Substitutions: their base classes, a text as one, and the error of one that has no text.

Arguments accept `SomeSubstitutionsType` in their place.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, ClassVar, Union

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_home, ros_repr

__all__ = [
    "ParsedSubstitution",
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
    "SubstitutionFailure",
    "TextSubstitution",
    "described",
]


class Substitution(HasPrivateNames):
    """A text that is only known when the launch runs."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the text; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `perform` of its own.
        """
        raise NotImplementedError(
            f"{type(self).__name__} has no method 'perform', which returns the substitution's text"
        )

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)


SomeSubstitutionsType = Union[str, Substitution, Iterable[str | Substitution]]
"""What an argument accepts where it takes substitutions: a text, a substitution, or a list of both, concatenated."""

SomeSubstitutionsType_types_tuple = (str, Substitution, Iterable)
"""The same for `isinstance`."""


class SubstitutionFailure(RuntimeError):  # noqa: N818  # ROS's name
    """A substitution cannot be performed.

    Args:
        msg: What is wrong.
    """

    __module__ = ros_home("launch.substitutions.substitution_failure", __name__)

    def __init__(self, msg: object) -> None:
        super().__init__(msg)


def described(substitutions: Iterable[Substitution]) -> str:
    """Return the descriptions of substitutions that are concatenated."""
    return " + ".join(substitution.describe() for substitution in substitutions)


class TextSubstitution(Substitution):
    """A text.

    Args:
        text: The text itself.

    Raises:
        TypeError: `text` is not a text.
    """

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected Text object got '{type(text)}' instead.")
        self._text = text

    @property
    def text(self) -> str:
        """Text that the substitution stands for, whatever the context."""
        return self._text

    def describe(self) -> str:
        """Return a description for people."""
        return f"'{self._text}'"

    def perform(self, context: LaunchContext) -> str:
        """Return the text."""
        return self._text


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
