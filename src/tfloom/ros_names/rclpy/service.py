"""Service servers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.endpoints.service import ResponseFirst as ResponseFirst
from tfloom.node.endpoints.service import Service as Service
from tfloom.node.endpoints.service import ServiceEndpoint as ServiceEndpoint
from tfloom.node.endpoints.service import SrvType as SrvType
from tfloom.node.endpoints.service import SrvTypeRequest as SrvTypeRequest
from tfloom.node.endpoints.service import SrvTypeResponse as SrvTypeResponse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Clock="tfloom.node.clock.clock",
        QoSProfile="tfloom.node.qos.qos",
        ServiceIntrospectionState="tfloom.node.endpoints.service_introspection",
    )
