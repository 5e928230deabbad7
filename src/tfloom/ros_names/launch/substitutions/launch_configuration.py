"""The value of a launch configuration."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchContext="tfloom.launch.launch_context",
    )
