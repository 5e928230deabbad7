"""The services that read and set a node's parameters."""

from tfloom.interfaces.rcl_interfaces.msg import ListParametersResult as ListParametersResult
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters as DescribeParameters
from tfloom.interfaces.rcl_interfaces.srv import GetParameters as GetParameters
from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
from tfloom.interfaces.rcl_interfaces.srv import ListParameters as ListParameters
from tfloom.interfaces.rcl_interfaces.srv import SetParameters as SetParameters
from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically
from tfloom.node.builtin.parameter_service import *
from tfloom.node.parameters.exceptions import ParameterNotDeclaredException as ParameterNotDeclaredException
from tfloom.node.parameters.exceptions import (
    ParameterUninitializedException as ParameterUninitializedException,
)
from tfloom.node.parameters.parameter import Parameter as Parameter
from tfloom.node.qos.qos import qos_profile_parameters as qos_profile_parameters
