"""Events of publishers and subscriptions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.event_handler import EventHandler as EventHandler
from tfloom.node.executing.event_handler import PublisherEventCallbacks as PublisherEventCallbacks
from tfloom.node.executing.event_handler import QoSEventHandler as QoSEventHandler
from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import IncompatibleTypeInfo as IncompatibleTypeInfo
    from tfloom.node.executing.event_handler import QoSLivelinessChangedInfo as QoSLivelinessChangedInfo
    from tfloom.node.executing.event_handler import QoSLivelinessLostInfo as QoSLivelinessLostInfo
    from tfloom.node.executing.event_handler import QoSMessageLostInfo as QoSMessageLostInfo
    from tfloom.node.executing.event_handler import QoSOfferedDeadlineMissedInfo as QoSOfferedDeadlineMissedInfo
    from tfloom.node.executing.event_handler import QoSOfferedIncompatibleQoSInfo as QoSOfferedIncompatibleQoSInfo
    from tfloom.node.executing.event_handler import QoSPublisherMatchedInfo as QoSPublisherMatchedInfo
    from tfloom.node.executing.event_handler import QoSRequestedDeadlineMissedInfo as QoSRequestedDeadlineMissedInfo
    from tfloom.node.executing.event_handler import QoSRequestedIncompatibleQoSInfo as QoSRequestedIncompatibleQoSInfo
    from tfloom.node.executing.event_handler import QoSSubscriptionMatchedInfo as QoSSubscriptionMatchedInfo
    from tfloom.node.executing.event_handler import UnsupportedEventTypeError as UnsupportedEventTypeError
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
        IncompatibleTypeInfo="tfloom.node.executing.event_handler",
        NumberOfEntities="tfloom.node.executing.waitable",
        QoSLivelinessChangedInfo="tfloom.node.executing.event_handler",
        QoSLivelinessLostInfo="tfloom.node.executing.event_handler",
        QoSMessageLostInfo="tfloom.node.executing.event_handler",
        QoSOfferedDeadlineMissedInfo="tfloom.node.executing.event_handler",
        QoSOfferedIncompatibleQoSInfo="tfloom.node.executing.event_handler",
        QoSPublisherEventType="tfloom.node.executing.event_types",
        QoSPublisherMatchedInfo="tfloom.node.executing.event_handler",
        QoSRequestedDeadlineMissedInfo="tfloom.node.executing.event_handler",
        QoSRequestedIncompatibleQoSInfo="tfloom.node.executing.event_handler",
        QoSSubscriptionEventType="tfloom.node.executing.event_types",
        QoSSubscriptionMatchedInfo="tfloom.node.executing.event_handler",
        UnsupportedEventTypeError="tfloom.node.executing.event_handler",
        Waitable="tfloom.node.executing.waitable",
        get_logger="tfloom.node.log.logging",
        qos_policy_name_from_kind="tfloom.node.qos.qos",
    )
