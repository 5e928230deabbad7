"""A condition that holds where a text is true."""

from __future__ import annotations

from tfloom.launch.condition import Condition
from tfloom.launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitutions.described import described
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["IfCondition"]


class IfCondition(Condition):
    """A condition that holds if a text is `true` or `1`, and not if it is `false` or `0`, in any case.

    Args:
        predicate_expression: The text.
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        self._predicate_expression = normalize_to_list_of_substitutions(predicate_expression)
        super().__init__(predicate=self._is_true)

    def _is_true(self, context: LaunchContext) -> bool:
        return evaluate_condition_expression(context, self._predicate_expression)

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}({described(self._predicate_expression)})"
