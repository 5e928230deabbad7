"""Remove a launch configuration."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["UnsetLaunchConfiguration"]


class UnsetLaunchConfiguration(Action):
    """Removes a launch configuration when it is executed; one that isn't set is no error.

    Args:
        name: Name of the configuration; it may have substitutions.
        kwargs: As for Action.
    """

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    @property
    def name(self) -> list[Substitution]:
        """The name."""
        return self.__name

    def execute(self, context: LaunchContext) -> None:
        """Remove it."""
        context.launch_configurations.pop(perform_substitutions(context, self.__name), None)
