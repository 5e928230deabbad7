"""Command lines with their folder and environment."""

from typing import TYPE_CHECKING

from tfloom.launch.descriptions.executable import Executable as Executable
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
    )
