"""The service that returns the definitions of a node's types."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.type_description_service import START_TYPE_DESCRIPTION_SERVICE_PARAM as START_TYPE_DESCRIPTION_SERVICE_PARAM
from tfloom.node.builtin.type_description_service import TOPIC_SEPARATOR_STRING as TOPIC_SEPARATOR_STRING
from tfloom.node.builtin.type_description_service import TypeDescriptionService as TypeDescriptionService

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
    from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
    from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription as GetTypeDescription
    from tfloom.node.endpoints.service import Service as Service
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        GetTypeDescription="tfloom.interfaces.type_description_interfaces.srv",
        Parameter="tfloom.node.parameters.parameter",
        ParameterDescriptor="tfloom.interfaces.rcl_interfaces.msg",
        ParameterType="tfloom.interfaces.rcl_interfaces.msg",
        Service="tfloom.node.endpoints.service",
        check_is_valid_srv_type="tfloom.node.values.type_support",
        qos_profile_services_default="tfloom.node.qos.qos",
    )
