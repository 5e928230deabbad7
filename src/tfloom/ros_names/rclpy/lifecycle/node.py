"""Lifecycle nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.lifecycle.node import LifecycleNode as LifecycleNode
from tfloom.node.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
from tfloom.node.lifecycle.node import LifecycleState as LifecycleState

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.endpoints.service import Service as Service
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.lifecycle.managed_entity import ManagedEntity as ManagedEntity
    from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn as TransitionCallbackReturn
    from tfloom.node.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
    from tfloom.node.node import Node as Node
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        LifecyclePublisher="tfloom.node.lifecycle.publisher",
        ManagedEntity="tfloom.node.lifecycle.managed_entity",
        Node="tfloom.node.node",
        QoSProfile="tfloom.node.qos.qos",
        Service="tfloom.node.endpoints.service",
        TransitionCallbackReturn="tfloom.node.lifecycle.managed_entity",
        check_is_valid_srv_type="tfloom.node.values.type_support",
    )
