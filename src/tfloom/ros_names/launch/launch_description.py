"""Launch descriptions."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity

if TYPE_CHECKING:
    from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument as DeclareLaunchArgument
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DeclareLaunchArgument="tfloom.launch.actions.declare_launch_argument",
    )
