"""The truth value of a condition's text."""

from __future__ import annotations

from tfloom.launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["VALID_FALSE_EXPRESSIONS", "VALID_TRUE_EXPRESSIONS", "evaluate_condition_expression"]

VALID_TRUE_EXPRESSIONS = ["true", "1"]
VALID_FALSE_EXPRESSIONS = ["false", "0"]


def evaluate_condition_expression(context: LaunchContext, expression: list[Substitution]) -> bool:
    """Return whether the text of substitutions is true, whatever its case and the spaces around it.

    Raises:
        InvalidConditionExpressionError: it is neither true, false, 1 nor 0.
    """
    text = perform_substitutions(context, expression)
    word = text.strip().lower()
    if word in VALID_TRUE_EXPRESSIONS:
        return True
    if word in VALID_FALSE_EXPRESSIONS:
        return False
    raise InvalidConditionExpressionError(text, expression, VALID_TRUE_EXPRESSIONS + VALID_FALSE_EXPRESSIONS)
