"""Logs of a launch: on the screen, in the launch's log folder, and a process's own files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.logging import LaunchConfig as LaunchConfig
from tfloom.launch.logging import LaunchLogger as LaunchLogger
from tfloom.launch.logging import get_logger as get_logger
from tfloom.launch.logging import get_output_loggers as get_output_loggers
from tfloom.launch.logging import log_launch_config as log_launch_config
from tfloom.launch.logging import reset as reset

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.logging import handlers as handlers
    from tfloom.launch.logging import launch_config as launch_config
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        handlers="launch.logging",
        launch_config="tfloom.launch.logging",
    )
