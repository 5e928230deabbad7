"""Service clients."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.endpoints.client import Client as Client
from tfloom.node.endpoints.client import NoResponseError as NoResponseError
from tfloom.node.endpoints.client import SrvType as SrvType
from tfloom.node.endpoints.client import SrvTypeRequest as SrvTypeRequest
from tfloom.node.endpoints.client import SrvTypeResponse as SrvTypeResponse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.context.context import Context as Context
    from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Clock="tfloom.node.clock.clock",
        Context="tfloom.node.context.context",
        Future="tfloom.node.executing.task",
        QoSProfile="tfloom.node.qos.qos",
        ServiceIntrospectionState="tfloom.node.endpoints.service_introspection",
    )
