"""Types of parameters: as launch files give them, normalized, and evaluated."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.parameters_type import EvaluatedParameters as EvaluatedParameters
    from tfloom.launch.ros.parameters_type import EvaluatedParameterValue as EvaluatedParameterValue
    from tfloom.launch.ros.parameters_type import ParameterDescription as ParameterDescription
    from tfloom.launch.ros.parameters_type import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameters_type import ParameterName as ParameterName
    from tfloom.launch.ros.parameters_type import Parameters as Parameters
    from tfloom.launch.ros.parameters_type import ParametersDict as ParametersDict
    from tfloom.launch.ros.parameters_type import ParameterValue as ParameterValue
    from tfloom.launch.ros.parameters_type import ParameterValueDescription as ParameterValueDescription
    from tfloom.launch.ros.parameters_type import SomeParameterFile as SomeParameterFile
    from tfloom.launch.ros.parameters_type import SomeParameterName as SomeParameterName
    from tfloom.launch.ros.parameters_type import SomeParameters as SomeParameters
    from tfloom.launch.ros.parameters_type import SomeParametersDict as SomeParametersDict
    from tfloom.launch.ros.parameters_type import SomeParameterValue as SomeParameterValue
    from tfloom.launch.ros.parameters_type import (
        SomeParameterValue_types_tuple as SomeParameterValue_types_tuple,
    )
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import (
        SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
    )
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EvaluatedParameterValue="tfloom.launch.ros.parameters_type",
        EvaluatedParameters="tfloom.launch.ros.parameters_type",
        ParameterDescription="tfloom.launch.ros.parameters_type",
        ParameterFile="tfloom.launch.ros.parameters_type",
        ParameterName="tfloom.launch.ros.parameters_type",
        ParameterValue="tfloom.launch.ros.parameters_type",
        ParameterValueDescription="tfloom.launch.ros.parameters_type",
        Parameters="tfloom.launch.ros.parameters_type",
        ParametersDict="tfloom.launch.ros.parameters_type",
        SomeParameterFile="tfloom.launch.ros.parameters_type",
        SomeParameterName="tfloom.launch.ros.parameters_type",
        SomeParameterValue="tfloom.launch.ros.parameters_type",
        SomeParameterValue_types_tuple="tfloom.launch.ros.parameters_type",
        SomeParameters="tfloom.launch.ros.parameters_type",
        SomeParametersDict="tfloom.launch.ros.parameters_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
    )
