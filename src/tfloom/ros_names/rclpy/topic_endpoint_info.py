"""Description of a publisher or subscription on the graph."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.qos.topic_endpoint_info import TopicEndpointInfo as TopicEndpointInfo
from tfloom.node.qos.topic_endpoint_info import TopicEndpointTypeEnum as TopicEndpointTypeEnum

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.qos.qos import QoSHistoryPolicy as QoSHistoryPolicy
    from tfloom.node.qos.qos import QoSPresetProfiles as QoSPresetProfiles
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.values.type_hash import TypeHash as TypeHash
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        QoSHistoryPolicy="tfloom.node.qos.qos",
        QoSPresetProfiles="tfloom.node.qos.qos",
        QoSProfile="tfloom.node.qos.qos",
        TypeHash="tfloom.node.values.type_hash",
    )
