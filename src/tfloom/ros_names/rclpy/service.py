"""Service servers."""

from typing import TYPE_CHECKING

from tfloom.node.endpoints.service import *
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from tfloom.node.qos.qos import QoSProfile as QoSProfile

if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Clock="tfloom.node.clock.clock",
        CallbackGroup="tfloom.node.executing.callback_groups",
    )
