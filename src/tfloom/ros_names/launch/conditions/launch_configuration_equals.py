"""A condition on the value of a launch configuration."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.launch_configuration_equals import *

if TYPE_CHECKING:
    from tfloom.launch.condition import Condition as Condition
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Condition="tfloom.launch.condition",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
