"""Conditions of actions, as texts and substitutions that are true or false."""

from __future__ import annotations

import warnings
from collections.abc import Sequence

from tfloom.launch.core.base_classes import Condition, SomeSubstitutionsType, Substitution, described
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.ros_imports.guard import ros_home

__all__ = [
    "VALID_FALSE_EXPRESSIONS",
    "VALID_TRUE_EXPRESSIONS",
    "IfCondition",
    "InvalidConditionExpressionError",
    "LaunchConfigurationEquals",
    "LaunchConfigurationNotEquals",
    "UnlessCondition",
    "evaluate_condition_expression",
]


class InvalidConditionExpressionError(ValueError):
    """A condition's text is neither true nor false.

    Args:
        expression: The text.
        unexpanded_expression: The substitutions whose text it is.
        valid_expressions: The texts that are allowed.
    """

    __module__ = ros_home("launch.conditions.invalid_condition_expression_error", __name__)

    def __init__(
        self, expression: str, unexpanded_expression: Sequence[Substitution], valid_expressions: Sequence[str]
    ) -> None:
        super().__init__(
            f"invalid condition expression, expected one of [{', '.join(valid_expressions)}] "
            f"but got '{expression}', expanded from '{described(unexpanded_expression)}'"
        )


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


class IfCondition(Condition):
    """A condition that holds if a text is `true` or `1`, and not if it is `false` or `0`, in any case.

    Args:
        predicate_expression: The text.
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        self._predicate_expression = normalize_to_list_of_substitutions(predicate_expression)
        super().__init__(predicate=self._predicate_func)

    def _predicate_func(self, context: LaunchContext) -> bool:
        # Launch files of rtabmap and others call it by this name.
        return evaluate_condition_expression(context, self._predicate_expression)

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}({described(self._predicate_expression)})"


class UnlessCondition(IfCondition):
    """A condition that holds if a text is `false` or `0`, and not if it is `true` or `1`, in any case."""

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not super()._predicate_func(context)


class LaunchConfigurationEquals(Condition):
    """A condition that holds if a launch configuration has a value. Deprecated: use EqualsSubstitution.

    Args:
        launch_configuration_name: Name of the configuration.
        expected_value: Its value; None: the condition holds if it isn't set.
    """

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None) -> None:
        warnings.warn(
            f"{type(self).__name__} is deprecated. Use EqualsSubstitution or NotEqualsSubstitution instead: "
            "IfCondition(EqualsSubstitution(LaunchConfiguration('name'), 'value'))",
            UserWarning,
            stacklevel=2,
        )
        self._name = launch_configuration_name
        self._expected_value: list[Substitution] | None = None
        if expected_value is not None:
            self._expected_value = normalize_to_list_of_substitutions(expected_value)
        super().__init__(predicate=self._predicate_func)

    def _predicate_func(self, context: LaunchContext) -> bool:
        value = context.launch_configurations.get(self._name)
        if self._expected_value is None:
            return value is None
        return value == perform_substitutions(context, self._expected_value)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """A condition that holds if a launch configuration does not have a value. Deprecated: use NotEqualsSubstitution."""

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not super()._predicate_func(context)
