"""Callbacks for parameter changes of any node."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.parameter_event_handler import ParameterCallbackHandle as ParameterCallbackHandle
from tfloom.node.builtin.parameter_event_handler import ParameterEventCallbackHandle as ParameterEventCallbackHandle
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler as ParameterEventHandler

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent as ParameterEvent
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
    from tfloom.node.node import Node as Node
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import qos_profile_parameter_events as qos_profile_parameter_events
    from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Node="tfloom.node.node",
        Parameter="tfloom.node.parameters.parameter",
        ParameterEvent="tfloom.interfaces.rcl_interfaces.msg",
        QoSOverridingOptions="tfloom.node.qos.qos_overriding_options",
        QoSProfile="tfloom.node.qos.qos",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
        qos_profile_parameter_events="tfloom.node.qos.qos",
    )
