"""The loading of launch files in Python."""

from typing import TYPE_CHECKING

from tfloom.launch.launch_description_sources.python_launch_file_utilities import *

if TYPE_CHECKING:
    from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchDescription="tfloom.launch.launch_description",
    )
