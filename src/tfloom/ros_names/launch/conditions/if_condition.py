"""A condition that holds where a text is true."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.if_condition import *

if TYPE_CHECKING:
    from tfloom.launch.condition import Condition as Condition
    from tfloom.launch.conditions.evaluate_condition_expression_impl import (
        evaluate_condition_expression as evaluate_condition_expression,
    )
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Condition="tfloom.launch.condition",
        evaluate_condition_expression="tfloom.launch.conditions.evaluate_condition_expression_impl",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
    )
