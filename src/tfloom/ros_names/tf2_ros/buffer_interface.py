"""Base of buffers: transform objects by the functions registered for their types."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.buffer_interface import BufferInterface as BufferInterface
from tfloom.tf2_ros.buffer_interface import ConvertRegistration as ConvertRegistration
from tfloom.tf2_ros.buffer_interface import NotImplementedException as NotImplementedException
from tfloom.tf2_ros.buffer_interface import Stamped as Stamped
from tfloom.tf2_ros.buffer_interface import TransformRegistration as TransformRegistration
from tfloom.tf2_ros.buffer_interface import TypeException as TypeException
from tfloom.tf2_ros.buffer_interface import convert as convert

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
    from tfloom.interfaces.geometry_msgs.msg import PoseStamped as PoseStamped
    from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.geometry_msgs.msg import Vector3Stamped as Vector3Stamped
    from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
    from tfloom.interfaces.std_msgs.msg import Header as Header
    from tfloom.node.values.duration import Duration as Duration
    from tfloom.node.values.time import Time as Time
    from tfloom.tf2_ros.annotation_types import MsgStamped as MsgStamped
    from tfloom.tf2_ros.annotation_types import PyKDLType as PyKDLType
    from tfloom.tf2_ros.annotation_types import TransformableObject as TransformableObject
    from tfloom.tf2_ros.annotation_types import TransformableObjectType as TransformableObjectType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Duration="tfloom.node.values.duration",
        Header="tfloom.interfaces.std_msgs.msg",
        MsgStamped="tfloom.tf2_ros.annotation_types",
        PointCloud2="tfloom.interfaces.sensor_msgs.msg",
        PointStamped="tfloom.interfaces.geometry_msgs.msg",
        PoseStamped="tfloom.interfaces.geometry_msgs.msg",
        PoseWithCovarianceStamped="tfloom.interfaces.geometry_msgs.msg",
        PyKDLType="tfloom.tf2_ros.annotation_types",
        Time="tfloom.node.values.time",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
        TransformableObject="tfloom.tf2_ros.annotation_types",
        TransformableObjectType="tfloom.tf2_ros.annotation_types",
        Vector3Stamped="tfloom.interfaces.geometry_msgs.msg",
    )
