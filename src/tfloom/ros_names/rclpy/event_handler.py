"""Events of publishers and subscriptions."""

from typing import TYPE_CHECKING

from tfloom.node.executing.event_handler import *

if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_types import QoSPublisherEventType as QoSPublisherEventType
    from tfloom.node.executing.event_types import QoSSubscriptionEventType as QoSSubscriptionEventType
    from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.log.logging import get_logger as get_logger
    from tfloom.node.qos.qos import qos_policy_name_from_kind as qos_policy_name_from_kind
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        QoSPublisherEventType="tfloom.node.executing.event_types",
        QoSSubscriptionEventType="tfloom.node.executing.event_types",
        NumberOfEntities="tfloom.node.executing.waitable",
        Waitable="tfloom.node.executing.waitable",
        get_logger="tfloom.node.log.logging",
        qos_policy_name_from_kind="tfloom.node.qos.qos",
    )
