"""Types of parameters: as launch files give them, normalized, and evaluated."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.parameters_type import EvaluatedParameterValue as EvaluatedParameterValue
from tfloom.launch.ros.parameters_type import EvaluatedParameters as EvaluatedParameters
from tfloom.launch.ros.parameters_type import ParameterName as ParameterName
from tfloom.launch.ros.parameters_type import ParameterValue as ParameterValue
from tfloom.launch.ros.parameters_type import Parameters as Parameters
from tfloom.launch.ros.parameters_type import ParametersDict as ParametersDict
from tfloom.launch.ros.parameters_type import SomeParameterFile as SomeParameterFile
from tfloom.launch.ros.parameters_type import SomeParameterName as SomeParameterName
from tfloom.launch.ros.parameters_type import SomeParameterValue as SomeParameterValue
from tfloom.launch.ros.parameters_type import SomeParameterValue_types_tuple as SomeParameterValue_types_tuple
from tfloom.launch.ros.parameters_type import SomeParameters as SomeParameters
from tfloom.launch.ros.parameters_type import SomeParametersDict as SomeParametersDict
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameters_type import ParameterDescription as ParameterDescription
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ParameterDescription="tfloom.launch.ros.parameters_type",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
    )
