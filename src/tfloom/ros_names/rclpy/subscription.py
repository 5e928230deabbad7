"""Subscriptions."""

from typing import TYPE_CHECKING

from tfloom.node.endpoints.subscription import *
from tfloom.node.qos.qos import QoSProfile as QoSProfile

if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import EventHandler as EventHandler
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        EventHandler="tfloom.node.executing.event_handler",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
    )
