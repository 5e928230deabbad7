"""A condition that holds where a text is false."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.unless_condition import *

if TYPE_CHECKING:
    from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IfCondition="tfloom.launch.conditions.if_condition",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
