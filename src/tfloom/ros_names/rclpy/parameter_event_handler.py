"""Callbacks for parameter changes of any node."""

from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent as ParameterEvent
from tfloom.node.builtin.parameter_event_handler import *
from tfloom.node.parameters.parameter import Parameter as Parameter
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.qos.qos import qos_profile_parameter_events as qos_profile_parameter_events

if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
    from tfloom.node.node import Node as Node
    from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
        Node="tfloom.node.node",
        QoSOverridingOptions="tfloom.node.qos.qos_overriding_options",
    )
