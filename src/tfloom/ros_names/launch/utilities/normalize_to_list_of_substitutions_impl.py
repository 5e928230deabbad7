"""Substitutions in every form as a list."""

from typing import TYPE_CHECKING

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)

if TYPE_CHECKING:
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        is_a_subclass="tfloom.launch.utilities.class_tools",
    )
