"""Publishers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.endpoints.publisher import MsgType as MsgType
from tfloom.node.endpoints.publisher import Publisher as Publisher

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import EventHandler as EventHandler
    from tfloom.node.executing.event_handler import PublisherEventCallbacks as PublisherEventCallbacks
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.values.duration import Duration as Duration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Duration="tfloom.node.values.duration",
        EventHandler="tfloom.node.executing.event_handler",
        PublisherEventCallbacks="tfloom.node.executing.event_handler",
        QoSProfile="tfloom.node.qos.qos",
    )
