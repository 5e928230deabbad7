"""The loading of launch files in other languages than Python."""

from typing import TYPE_CHECKING

from tfloom.launch.launch_description_sources.frontend_launch_file_utilities import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidFrontendLaunchFileError="tfloom.launch.frontend.parser",
        Parser="tfloom.launch.frontend.parser",
        LaunchDescription="tfloom.launch.launch_description",
    )
