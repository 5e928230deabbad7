"""The loading of launch files in any language."""

from typing import TYPE_CHECKING

from tfloom.launch.launch_description_sources.any_launch_file_utilities import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
    from tfloom.launch.launch_description_sources.frontend_launch_file_utilities import (
        get_launch_description_from_frontend_launch_file as get_launch_description_from_frontend_launch_file,
    )
    from tfloom.launch.launch_description_sources.python_launch_file_utilities import (
        get_launch_description_from_python_launch_file as get_launch_description_from_python_launch_file,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
        InvalidLaunchFileError="tfloom.launch.invalid_launch_file_error",
        LaunchDescription="tfloom.launch.launch_description",
        get_launch_description_from_frontend_launch_file="tfloom.launch.launch_description_sources.frontend_launch_file_utilities",
        get_launch_description_from_python_launch_file="tfloom.launch.launch_description_sources.python_launch_file_utilities",
    )
