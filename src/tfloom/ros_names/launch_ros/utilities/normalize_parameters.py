"""Parameters in every form, normalized: files, and mappings of names to values without mappings in them."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameters_type import ParameterDescription as ParameterDescription
    from tfloom.launch.ros.parameters_type import Parameters as Parameters
    from tfloom.launch.ros.parameters_type import ParametersDict as ParametersDict
    from tfloom.launch.ros.parameters_type import ParameterValue as ParameterValue
    from tfloom.launch.ros.parameters_type import ParameterValueDescription as ParameterValueDescription
    from tfloom.launch.ros.parameters_type import SomeParameters as SomeParameters
    from tfloom.launch.ros.parameters_type import SomeParametersDict as SomeParametersDict
    from tfloom.launch.ros.parameters_type import SomeParameterValue as SomeParameterValue
    from tfloom.launch.ros.utilities.normalize_parameters import (
        normalize_parameter_dict as normalize_parameter_dict,
    )
    from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters as normalize_parameters
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import (
        SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
    )
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.substitutions.text_substitution import TextSubstitution as TextSubstitution
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ParameterDescription="tfloom.launch.ros.parameters_type",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        ParameterValue="tfloom.launch.ros.parameters_type",
        ParameterValueDescription="tfloom.launch.ros.parameters_type",
        Parameters="tfloom.launch.ros.parameters_type",
        ParametersDict="tfloom.launch.ros.parameters_type",
        SomeParameterValue="tfloom.launch.ros.parameters_type",
        SomeParameters="tfloom.launch.ros.parameters_type",
        SomeParametersDict="tfloom.launch.ros.parameters_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        TextSubstitution="tfloom.launch.substitutions.text_substitution",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        normalize_parameter_dict="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_parameters="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
    )
