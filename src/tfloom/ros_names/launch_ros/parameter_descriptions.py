"""Parameters of nodes as launch files describe them: a value with its type, a name with a value, a file."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.frontend.parse_substitution import parse_substitution as parse_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.parameter_descriptions import Parameter as Parameter
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameter_descriptions import ParameterValue as ParameterValue
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import (
        SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
    )
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
    from tfloom.launch.utilities.type_utils import SomeValueType as SomeValueType
    from tfloom.launch.utilities.type_utils import (
        normalize_typed_substitution as normalize_typed_substitution,
    )
    from tfloom.launch.utilities.type_utils import perform_typed_substitution as perform_typed_substitution
    from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AllowedTypesType="tfloom.launch.utilities.type_utils",
        FilePath="tfloom.launch.utilities.typing_file_path",
        LaunchContext="tfloom.launch.launch_context",
        Parameter="tfloom.launch.ros.parameter_descriptions",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        ParameterValue="tfloom.launch.ros.parameter_descriptions",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        SomeValueType="tfloom.launch.utilities.type_utils",
        Substitution="tfloom.launch.substitution",
        SubstitutionFailure="tfloom.launch.substitutions.substitution_failure",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        normalize_typed_substitution="tfloom.launch.utilities.type_utils",
        parse_substitution="tfloom.launch.frontend.parse_substitution",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        perform_typed_substitution="tfloom.launch.utilities.type_utils",
    )
