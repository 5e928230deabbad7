"""The buffer of a program: lookups that wait for a transform, and futures of transforms."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.buffer import Buffer as Buffer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
    from tfloom.node.clock.time_jump import JumpThreshold as JumpThreshold
    from tfloom.node.clock.time_jump import TimeJump as TimeJump
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.node import Node as Node
    from tfloom.node.values.duration import Duration as Duration
    from tfloom.node.values.time import Time as Time
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvRequest as FrameGraphSrvRequest
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvResponse as FrameGraphSrvResponse
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Duration="tfloom.node.values.duration",
        FrameGraph="tfloom.interfaces.tf2_msgs.srv",
        FrameGraphSrvRequest="tfloom.tf2_ros.annotation_types",
        FrameGraphSrvResponse="tfloom.tf2_ros.annotation_types",
        Future="tfloom.node.executing.task",
        JumpThreshold="tfloom.node.clock.time_jump",
        Node="tfloom.node.node",
        Time="tfloom.node.values.time",
        TimeJump="tfloom.node.clock.time_jump",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
    )
