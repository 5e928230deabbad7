"""Group actions."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.group_action import GroupAction as GroupAction
from tfloom.launch.actions.pop_environment import PopEnvironment as PopEnvironment
from tfloom.launch.actions.pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
from tfloom.launch.actions.push_environment import PushEnvironment as PushEnvironment
from tfloom.launch.actions.push_launch_configurations import (
    PushLaunchConfigurations as PushLaunchConfigurations,
)
from tfloom.launch.actions.reset_environment import ResetEnvironment as ResetEnvironment
from tfloom.launch.actions.reset_launch_configurations import (
    ResetLaunchConfigurations as ResetLaunchConfigurations,
)
from tfloom.launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
    )
