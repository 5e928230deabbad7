"""Parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.parameters.parameter import PARAMETER_SEPARATOR_STRING as PARAMETER_SEPARATOR_STRING
from tfloom.node.parameters.parameter import Parameter as Parameter
from tfloom.node.parameters.parameter import get_parameter_value as get_parameter_value
from tfloom.node.parameters.parameter import parameter_dict_from_yaml_file as parameter_dict_from_yaml_file
from tfloom.node.parameters.parameter import parameter_value_to_python as parameter_value_to_python

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
    from tfloom.interfaces.rcl_interfaces.msg import ParameterValue as ParameterValue
    from tfloom.node.parameters.parameter import ParameterMsg as ParameterMsg
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ParameterMsg="tfloom.node.parameters.parameter",
        ParameterType="tfloom.interfaces.rcl_interfaces.msg",
        ParameterValue="tfloom.interfaces.rcl_interfaces.msg",
    )
