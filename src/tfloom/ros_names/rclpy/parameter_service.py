"""The services that read and set a node's parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.parameter_service import ParameterService as ParameterService
from tfloom.node.builtin.parameter_service import TOPIC_SEPARATOR_STRING as TOPIC_SEPARATOR_STRING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ListParametersResult as ListParametersResult
    from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
    from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters as DescribeParameters
    from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
    from tfloom.interfaces.rcl_interfaces.srv import GetParameters as GetParameters
    from tfloom.interfaces.rcl_interfaces.srv import ListParameters as ListParameters
    from tfloom.interfaces.rcl_interfaces.srv import SetParameters as SetParameters
    from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically
    from tfloom.node.parameters.exceptions import ParameterNotDeclaredException as ParameterNotDeclaredException
    from tfloom.node.parameters.exceptions import ParameterUninitializedException as ParameterUninitializedException
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.qos.qos import qos_profile_parameters as qos_profile_parameters
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DescribeParameters="tfloom.interfaces.rcl_interfaces.srv",
        GetParameterTypes="tfloom.interfaces.rcl_interfaces.srv",
        GetParameters="tfloom.interfaces.rcl_interfaces.srv",
        ListParameters="tfloom.interfaces.rcl_interfaces.srv",
        ListParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        Parameter="tfloom.node.parameters.parameter",
        ParameterNotDeclaredException="tfloom.node.parameters.exceptions",
        ParameterUninitializedException="tfloom.node.parameters.exceptions",
        SetParameters="tfloom.interfaces.rcl_interfaces.srv",
        SetParametersAtomically="tfloom.interfaces.rcl_interfaces.srv",
        SetParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        qos_profile_parameters="tfloom.node.qos.qos",
    )
