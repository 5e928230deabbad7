"""Parameters."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue as ParameterValue
from tfloom.node.parameters.parameter import *
