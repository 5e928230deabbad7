"""Publish static transforms on /tf_static."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
    from tfloom.node.node import Node as Node
    from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
    from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DurabilityPolicy="tfloom.node.qos.qos",
        HistoryPolicy="tfloom.node.qos.qos",
        Node="tfloom.node.node",
        QoSProfile="tfloom.node.qos.qos",
        TFMessage="tfloom.interfaces.tf2_msgs.msg",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
    )
