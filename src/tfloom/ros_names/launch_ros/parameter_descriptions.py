"""Parameters of nodes as launch files describe them: a value with its type, a name with a value, a file."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.parameter_descriptions import Parameter as Parameter
from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
from tfloom.launch.ros.parameter_descriptions import ParameterValue as ParameterValue
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
