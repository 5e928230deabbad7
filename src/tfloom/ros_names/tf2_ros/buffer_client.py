"""Look transforms up in the buffer of another program, by an action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.buffer_client import BufferClient as BufferClient

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.tf2_msgs.action import LookupTransform as LookupTransform
    from tfloom.node.action.client import ActionClient as ActionClient
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.node import Node as Node
    from tfloom.node.values.duration import Duration as Duration
    from tfloom.node.values.time import Time as Time
    from tfloom.tf2_ros.annotation_types import LookupTransformGoal as LookupTransformGoal
    from tfloom.tf2_ros.annotation_types import LookupTransformResult as LookupTransformResult
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ActionClient="tfloom.node.action.client",
        Clock="tfloom.node.clock.clock",
        Duration="tfloom.node.values.duration",
        LookupTransform="tfloom.interfaces.tf2_msgs.action",
        LookupTransformGoal="tfloom.tf2_ros.annotation_types",
        LookupTransformResult="tfloom.tf2_ros.annotation_types",
        Node="tfloom.node.node",
        Time="tfloom.node.values.time",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
    )
