"""Fill a buffer from /tf and /tf_static."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.transform_listener import DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC
from tfloom.tf2_ros.transform_listener import DEFAULT_TF_TOPIC as DEFAULT_TF_TOPIC
from tfloom.tf2_ros.transform_listener import StaticTransformListener as StaticTransformListener
from tfloom.tf2_ros.transform_listener import TransformListener as TransformListener

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
    from tfloom.node.executing.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
    from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
    from tfloom.node.node import Node as Node
    from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
    from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.tf2_ros.buffer import Buffer as Buffer
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Buffer="tfloom.tf2_ros.buffer",
        DurabilityPolicy="tfloom.node.qos.qos",
        HistoryPolicy="tfloom.node.qos.qos",
        Node="tfloom.node.node",
        QoSProfile="tfloom.node.qos.qos",
        ReentrantCallbackGroup="tfloom.node.executing.callback_groups",
        SingleThreadedExecutor="tfloom.node.executing.executors",
        TFMessage="tfloom.interfaces.tf2_msgs.msg",
    )
