"""Substitutions that compare values, combine truth values, and choose."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.type_utils import is_substitution, perform_typed_substitution

__all__ = [
    "AllSubstitution",
    "AndSubstitution",
    "AnySubstitution",
    "EqualsSubstitution",
    "IfElseSubstitution",
    "NotEqualsSubstitution",
    "NotSubstitution",
    "OrSubstitution",
    "TwoValues",
    "perform_boolean",
]


class TwoValues(ParsedSubstitution):
    """A text that two values decide, as derived classes define.

    Args:
        left: First value.
        right: Second value.
    """

    _arguments = ("left", "right")

    def __init__(self, left: list[Substitution], right: list[Substitution]) -> None:
        super().__init__()
        self._left = left
        self._right = right

    @property
    def left(self) -> list[Substitution]:
        """First operand, as substitutions."""
        return self._left

    @property
    def right(self) -> list[Substitution]:
        """Second operand, as substitutions."""
        return self._right

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}({described(self._left)} {described(self._right)})"


_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


def _normalized_operand(value: Any) -> list[Substitution]:
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if value is None or value in ([], ()):
        return normalize_to_list_of_substitutions("")
    return normalize_to_list_of_substitutions(str(value).lower() if isinstance(value, bool) else str(value))


def _as_number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _are_equal(left: str, right: str) -> bool:
    """Return whether texts are equal, as booleans (also 0 and 1), as numbers that are close, or as texts."""
    if left.lower() in _BOOLEANS and right.lower() in _BOOLEANS:
        return _BOOLEANS[left.lower()] == _BOOLEANS[right.lower()]
    numbers = _as_number(left), _as_number(right)
    if numbers[0] is not None and numbers[1] is not None:
        return math.isclose(numbers[0], numbers[1])
    return left == right


@expose_substitution("equals")
class EqualsSubstitution(TwoValues):
    """`true` if two values are equal, as booleans, as numbers (within a relative 1e-9) or as texts; else `false`.

    Args:
        left: First value: a text, a substitution, a list of them, a number, a boolean, or None for an empty text.
        right: Second value.
    """

    _fault = "equals substitution expects 2 arguments"

    def __init__(self, left: Any | Iterable[Any] | None, right: Any | Iterable[Any] | None) -> None:
        super().__init__(_normalized_operand(left), _normalized_operand(right))

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return "true" if self._equal(context) else "false"

    def _equal(self, context: LaunchContext) -> bool:
        return _are_equal(
            perform_substitutions(context, self._left), perform_substitutions(context, self._right)
        )


@expose_substitution("not-equals")
class NotEqualsSubstitution(EqualsSubstitution):
    """`false` if two values are equal, as `EqualsSubstitution` compares them, else `true`."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return "false" if self._equal(context) else "true"


def perform_boolean(context: LaunchContext, value: list[Substitution]) -> bool:
    """Return the truth value of a text: 0, 1, or one of YAML's words in any case.

    Raises:
        SubstitutionFailure: the text is none of them.
    """
    try:
        return bool(perform_typed_substitution(context, value, bool))
    except (TypeError, ValueError) as error:
        raise SubstitutionFailure(f"{described(value)} is neither true nor false: {error}") from error


def _text(value: object) -> str:
    return "true" if value else "false"


@expose_substitution("not")
class NotSubstitution(ParsedSubstitution):
    """`true` for false, and `false` for true.

    Args:
        value: What is negated.
    """

    _arguments = ("value",)
    _fault = "not substitution expects 1 argument"

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__()
        self._value = normalize_to_list_of_substitutions(value)

    @property
    def value(self) -> list[Substitution]:
        """Condition that is negated, as substitutions."""
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
        return _text(self._join([perform_boolean(context, operand) for operand in (self._left, self._right)]))


@expose_substitution("and")
class AndSubstitution(_OfTwo):
    """`true` if both values are true, else `false`.

    Args:
        left: First value.
        right: Second value.
    """

    _fault = "and substitution expects 2 arguments"
    _join = staticmethod(all)


@expose_substitution("or")
class OrSubstitution(_OfTwo):
    """`true` if at least one of two values is true, else `false`.

    Args:
        left: First value.
        right: Second value.
    """

    _fault = "or substitution expects 2 arguments"
    _join = staticmethod(any)


class _OfMany(Substitution):
    """Logic on any number of values, all of which are always performed."""

    _join: Callable[[Iterable[bool]], bool]
    """Takes the truth values, and returns that of the whole."""

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        super().__init__()
        self._args = [normalize_to_list_of_substitutions(operand) for operand in args]

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
        return f"{type(self).__name__}({' '.join(described(operand) for operand in self._args)})"

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`.

        Raises:
            SubstitutionFailure: a value is neither true nor false.
        """
        return _text(self._join([perform_boolean(context, operand) for operand in self._args]))


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


@expose_substitution("if")
class IfElseSubstitution(ParsedSubstitution):
    """One text where a condition is true, and another where it is false.

    Args:
        condition: A text that is true or false.
        if_value: Text where it is true.
        else_value: Text where it is false.

    Raises:
        RuntimeError: neither text is given.
    """

    _arguments = ("condition", "if_value", "else_value")
    _optional = 1
    _fault = "if substitution expects from 2 or 3 arguments"

    def __init__(
        self,
        condition: SomeSubstitutionsType,
        if_value: SomeSubstitutionsType = "",
        else_value: SomeSubstitutionsType = "",
    ) -> None:
        super().__init__()
        if not if_value and not else_value:
            raise RuntimeError("One of if_value and else_value must be specified")
        self._condition = normalize_to_list_of_substitutions(condition)
        self._if_value = normalize_to_list_of_substitutions(if_value)
        self._else_value = normalize_to_list_of_substitutions(else_value)

    @property
    def condition(self) -> list[Substitution]:
        """Text that is true or false."""
        return self._condition

    @property
    def if_value(self) -> list[Substitution]:
        """Text where the condition is true."""
        return self._if_value

    @property
    def else_value(self) -> list[Substitution]:
        """Text where the condition is false."""
        return self._else_value

    def describe(self) -> str:
        """Return a description for people."""
        parts = ", ".join(described(part) for part in (self._condition, self._if_value, self._else_value))
        return f"IfElseSubstitution({parts})"

    def perform(self, context: LaunchContext) -> str:
        """Return one of the texts; the other is not performed.

        Raises:
            SubstitutionFailure: the condition is neither true nor false.
        """
        chosen = self._if_value if perform_boolean(context, self._condition) else self._else_value
        return perform_substitutions(context, chosen)
