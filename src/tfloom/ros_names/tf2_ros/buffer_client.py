"""Look transforms up in the buffer of another program, by an action."""

from typing import TYPE_CHECKING

from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
from tfloom.node.clock.clock import Clock as Clock
from tfloom.node.node import Node as Node
from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.time import Time as Time
from tfloom.tf2_ros.buffer_client import *

if TYPE_CHECKING:
    from tfloom.interfaces.tf2_msgs.action import LookupTransform as LookupTransform
    from tfloom.node.action.client import ActionClient as ActionClient
    from tfloom.tf2_ros.annotation_types import LookupTransformGoal as LookupTransformGoal
    from tfloom.tf2_ros.annotation_types import LookupTransformResult as LookupTransformResult
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LookupTransform="tfloom.interfaces.tf2_msgs.action",
        ActionClient="tfloom.node.action.client",
        LookupTransformGoal="tfloom.tf2_ros.annotation_types",
        LookupTransformResult="tfloom.tf2_ros.annotation_types",
    )
