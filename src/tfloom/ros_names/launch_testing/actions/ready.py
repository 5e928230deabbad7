"""The report that tests can begin."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest

if TYPE_CHECKING:
    from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchDescriptionEntity="tfloom.launch.launch_description_entity",
    )
