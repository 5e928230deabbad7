"""The value of an environment variable."""

from typing import TYPE_CHECKING

from tfloom.launch.substitutions.environment_variable import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        expose_substitution="tfloom.launch.frontend.expose",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        SubstitutionFailure="tfloom.launch.substitutions.substitution_failure",
    )
