"""The value of a variable of the context."""

from typing import TYPE_CHECKING

from tfloom.launch.substitutions.local_substitution import *

if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchContext="tfloom.launch.launch_context",
        Substitution="tfloom.launch.substitution",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
    )
