"""Remove an environment variable."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.unset_environment_variable import (
    UnsetEnvironmentVariable as UnsetEnvironmentVariable,
)
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
    )
