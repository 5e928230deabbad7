"""One of two texts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.boolean_substitution import perform_boolean
from tfloom.launch.substitutions.described import described
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["IfElseSubstitution"]


@expose_substitution("if")
class IfElseSubstitution(Substitution):
    """One text where a condition is true, and another where it is false.

    Args:
        condition: A text that is true or false.
        if_value: Text where it is true.
        else_value: Text where it is false.

    Raises:
        RuntimeError: neither text is given.
    """

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

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[IfElseSubstitution], dict[str, Any]]:
        """Return the class and the arguments of `$(if condition if_value else_value)`.

        Raises:
            TypeError: there are not two or three arguments.
        """
        if len(data) not in {2, 3}:
            raise TypeError("if substitution expects from 2 or 3 arguments")
        return cls, dict(zip(("condition", "if_value", "else_value"), data, strict=False))

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
        parts = ", ".join(described(each) for each in (self._condition, self._if_value, self._else_value))
        return f"IfElseSubstitution({parts})"

    def perform(self, context: LaunchContext) -> str:
        """Return one of the texts; the other is not performed.

        Raises:
            SubstitutionFailure: the condition is neither true nor false.
        """
        chosen = self._if_value if perform_boolean(context, self._condition) else self._else_value
        return perform_substitutions(context, chosen)
