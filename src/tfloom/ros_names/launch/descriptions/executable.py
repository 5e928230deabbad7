"""Command lines with their folder and environment."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.descriptions.executable import Executable as Executable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchConfiguration="tfloom.launch.substitutions.launch_configuration",
    )
