"""The service that returns the definitions of a node's types."""

from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription as GetTypeDescription
from tfloom.node.builtin.type_description_service import *
from tfloom.node.parameters.parameter import Parameter as Parameter

if TYPE_CHECKING:
    from tfloom.node.endpoints.service import Service as Service
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Service="tfloom.node.endpoints.service",
        qos_profile_services_default="tfloom.node.qos.qos",
        check_is_valid_srv_type="tfloom.node.values.type_support",
    )
