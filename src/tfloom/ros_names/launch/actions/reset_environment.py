"""Restore the environment variables of the launch's start."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.reset_environment import ResetEnvironment as ResetEnvironment
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.launch_context import LaunchContext as LaunchContext

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
    )
