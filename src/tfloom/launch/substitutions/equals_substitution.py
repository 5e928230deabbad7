"""Whether two texts are equal."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.two_values import TwoValues
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions
from tfloom.launch.utilities.type_utils import is_substitution

__all__ = ["EqualsSubstitution"]

_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


def _normalized(value: Any) -> list[Substitution]:
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if value is None or value in ([], ()):
        return normalize_to_list_of_substitutions("")
    return normalize_to_list_of_substitutions(str(value).lower() if isinstance(value, bool) else str(value))


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _are_equal(left: str, right: str) -> bool:
    """Return whether texts are equal, as booleans (also 0 and 1), as numbers that are close, or as texts."""
    if left.lower() in _BOOLEANS and right.lower() in _BOOLEANS:
        return _BOOLEANS[left.lower()] == _BOOLEANS[right.lower()]
    numbers = _number(left), _number(right)
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

    _word = "equals"

    def __init__(self, left: Any | Iterable[Any] | None, right: Any | Iterable[Any] | None) -> None:
        super().__init__(_normalized(left), _normalized(right))

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return "true" if self._equal(context) else "false"

    def _equal(self, context: LaunchContext) -> bool:
        return _are_equal(
            perform_substitutions(context, self._left), perform_substitutions(context, self._right)
        )
