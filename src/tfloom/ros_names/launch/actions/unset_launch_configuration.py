"""Remove a launch configuration."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.unset_launch_configuration import (
    UnsetLaunchConfiguration as UnsetLaunchConfiguration,
)
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
