"""Logic on substitutions whose texts are true or false."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.substitutions.two_values import TwoValues
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions
from tfloom.launch.utilities.type_utils import perform_typed_substitution

__all__ = [
    "AllSubstitution",
    "AndSubstitution",
    "AnySubstitution",
    "NotSubstitution",
    "OrSubstitution",
    "perform_boolean",
]

_NUMBERS = {"0": False, "1": True}


def perform_boolean(context: LaunchContext, value: list[Substitution]) -> bool:
    """Return the truth value of a text: 0, 1, or one of YAML's words.

    Raises:
        SubstitutionFailure: the text is none of them.
    """
    text = perform_substitutions(context, value).strip()
    if text in _NUMBERS:
        return _NUMBERS[text]
    try:
        return bool(perform_typed_substitution(context, value, bool))
    except (TypeError, ValueError) as error:
        raise SubstitutionFailure(f"{described(value)} is neither true nor false: {error}") from error


def _text(value: object) -> str:
    return "true" if value else "false"


@expose_substitution("not")
class NotSubstitution(Substitution):
    """`true` for false, and `false` for true.

    Args:
        value: What is negated.
    """

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__()
        self._value = normalize_to_list_of_substitutions(value)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[NotSubstitution], dict[str, Any]]:
        """Return the class and the arguments of `$(not value)`.

        Raises:
            TypeError: there is not exactly one argument.
        """
        if len(data) != 1:
            raise TypeError("not substitution expects 1 argument")
        return cls, {"value": data[0]}

    @property
    def value(self) -> list[Substitution]:
        """What is negated."""
        return self._value

    def describe(self) -> str:
        """Return a description for people."""
        return f"NotSubstitution({described(self._value)})"

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`.

        Raises:
            SubstitutionFailure: the value is neither true nor false.
        """
        return _text(not perform_boolean(context, self._value))


class _OfTwo(TwoValues):
    """Logic on two values, both of which are always performed."""

    _join: Callable[[Iterable[bool]], bool]
    """Takes the truth values, and returns that of the whole."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        super().__init__(normalize_to_list_of_substitutions(left), normalize_to_list_of_substitutions(right))

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`.

        Raises:
            SubstitutionFailure: a value is neither true nor false.
        """
        return _text(self._join([perform_boolean(context, each) for each in (self._left, self._right)]))


@expose_substitution("and")
class AndSubstitution(_OfTwo):
    """`true` if both values are true, else `false`.

    Args:
        left: First value.
        right: Second value.
    """

    _word = "and"
    _join = staticmethod(all)


@expose_substitution("or")
class OrSubstitution(_OfTwo):
    """`true` if at least one of two values is true, else `false`.

    Args:
        left: First value.
        right: Second value.
    """

    _word = "or"
    _join = staticmethod(any)


class _OfMany(Substitution):
    """Logic on any number of values, all of which are always performed."""

    _join: Callable[[Iterable[bool]], bool]
    """Takes the truth values, and returns that of the whole."""

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        super().__init__()
        self._args = [normalize_to_list_of_substitutions(each) for each in args]

    @classmethod
    def parse(cls, data: Iterable[SomeSubstitutionsType]) -> tuple[type[_OfMany], dict[str, Any]]:
        """Return the class and the arguments."""
        return cls, {"args": data}

    @property
    def args(self) -> list[list[Substitution]]:
        """Values, in order."""
        return self._args

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}({' '.join(described(each) for each in self._args)})"

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`.

        Raises:
            SubstitutionFailure: a value is neither true nor false.
        """
        return _text(self._join([perform_boolean(context, each) for each in self._args]))


@expose_substitution("any")
class AnySubstitution(_OfMany):
    """`true` if at least one value is true, else `false`.

    Args:
        args: The values.
    """

    _join = staticmethod(any)


@expose_substitution("all")
class AllSubstitution(_OfMany):
    """`true` if all values are true, else `false`.

    Args:
        args: The values.
    """

    _join = staticmethod(all)
