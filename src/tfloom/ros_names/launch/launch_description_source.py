"""Where an included launch description comes from."""

from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
from tfloom.launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
