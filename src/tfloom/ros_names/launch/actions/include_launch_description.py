"""Include a launch description."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.include_launch_description import (
    IncludeLaunchDescription as IncludeLaunchDescription,
)
from tfloom.launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.frontend.parser import Parser as Parser
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
from tfloom.launch.launch_description_sources.any_launch_description_source import (
    AnyLaunchDescriptionSource as AnyLaunchDescriptionSource,
)
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
