"""The error of a condition that is neither true nor false."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.invalid_condition_expression_error import *

if TYPE_CHECKING:
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Substitution="tfloom.launch.substitution",
    )
