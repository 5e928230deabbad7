"""Handler that adds a description to the launch."""

from typing import TYPE_CHECKING

from tfloom.launch.event_handler import EventHandler as EventHandler
from tfloom.launch.event_handlers.on_include_launch_description import (
    OnIncludeLaunchDescription as OnIncludeLaunchDescription,
)

if TYPE_CHECKING:
    from tfloom.launch.events.include_launch_description import (
        IncludeLaunchDescription as IncludeLaunchDescription,
    )
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IncludeLaunchDescription="tfloom.launch.events.include_launch_description",
        is_a_subclass="tfloom.launch.utilities.class_tools",
    )
