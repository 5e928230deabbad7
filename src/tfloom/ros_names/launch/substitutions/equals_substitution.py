"""Whether two texts are equal."""

from typing import TYPE_CHECKING

from tfloom.launch.substitutions.equals_substitution import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.launch.utilities.type_utils import is_substitution as is_substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        expose_substitution="tfloom.launch.frontend.expose",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        is_substitution="tfloom.launch.utilities.type_utils",
    )
