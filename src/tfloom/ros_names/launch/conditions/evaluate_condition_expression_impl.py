"""The truth value of a condition's text."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.evaluate_condition_expression_impl import *

if TYPE_CHECKING:
    from tfloom.launch.conditions.invalid_condition_expression_error import (
        InvalidConditionExpressionError as InvalidConditionExpressionError,
    )
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidConditionExpressionError="tfloom.launch.conditions.invalid_condition_expression_error",
        LaunchContext="tfloom.launch.launch_context",
        Substitution="tfloom.launch.substitution",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
