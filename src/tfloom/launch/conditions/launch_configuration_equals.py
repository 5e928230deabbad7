"""A condition on the value of a launch configuration."""

from __future__ import annotations

import warnings

from tfloom.launch.condition import Condition
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["LaunchConfigurationEquals"]


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
        super().__init__(predicate=self._is_equal)

    def _is_equal(self, context: LaunchContext) -> bool:
        value = context.launch_configurations.get(self._name)
        if self._expected_value is None:
            return value is None
        return value == perform_substitutions(context, self._expected_value)
