"""A description to launch."""

from typing import TYPE_CHECKING

from tfloom.launch.event import Event as Event
from tfloom.launch.launch_description import LaunchDescription as LaunchDescription

if TYPE_CHECKING:
    from tfloom.launch.events.include_launch_description import (
        IncludeLaunchDescription as IncludeLaunchDescription,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IncludeLaunchDescription="tfloom.launch.events.include_launch_description",
    )
