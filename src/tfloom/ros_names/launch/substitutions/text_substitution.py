"""A text as a substitution."""

from typing import TYPE_CHECKING

from tfloom.launch.substitutions.text_substitution import *

if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchContext="tfloom.launch.launch_context",
        Substitution="tfloom.launch.substitution",
    )
