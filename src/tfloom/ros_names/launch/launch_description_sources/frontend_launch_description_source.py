"""Launch descriptions in files of other languages than Python."""

from typing import TYPE_CHECKING

from tfloom.launch.launch_description_sources.frontend_launch_description_source import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
    from tfloom.launch.launch_description_sources.frontend_launch_file_utilities import (
        get_launch_description_from_frontend_launch_file as get_launch_description_from_frontend_launch_file,
    )
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
        LaunchDescriptionSource="tfloom.launch.launch_description_source",
        get_launch_description_from_frontend_launch_file="tfloom.launch.launch_description_sources.frontend_launch_file_utilities",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
