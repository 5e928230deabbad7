"""Whether two texts differ."""

from typing import TYPE_CHECKING

from tfloom.launch.substitutions.not_equals_substitution import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.substitutions.equals_substitution import EqualsSubstitution as EqualsSubstitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        expose_substitution="tfloom.launch.frontend.expose",
        LaunchContext="tfloom.launch.launch_context",
        EqualsSubstitution="tfloom.launch.substitutions.equals_substitution",
    )
