"""A condition on a value that a launch configuration does not have."""

from typing import TYPE_CHECKING

from tfloom.launch.conditions.launch_configuration_not_equals import *

if TYPE_CHECKING:
    from tfloom.launch.conditions.launch_configuration_equals import (
        LaunchConfigurationEquals as LaunchConfigurationEquals,
    )
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchConfigurationEquals="tfloom.launch.conditions.launch_configuration_equals",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
