"""Subscriptions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.endpoints.subscription import MsgType as MsgType
from tfloom.node.endpoints.subscription import Subscription as Subscription

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import EventHandler as EventHandler
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        EventHandler="tfloom.node.executing.event_handler",
        QoSProfile="tfloom.node.qos.qos",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
    )
