"""Transform geometry_msgs; importing this module registers them for `Buffer.transform`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.geometry import do_transform_point as do_transform_point
from tfloom.tf2_ros.geometry import do_transform_polygon as do_transform_polygon
from tfloom.tf2_ros.geometry import do_transform_polygon_stamped as do_transform_polygon_stamped
from tfloom.tf2_ros.geometry import do_transform_pose as do_transform_pose
from tfloom.tf2_ros.geometry import do_transform_pose_stamped as do_transform_pose_stamped
from tfloom.tf2_ros.geometry import do_transform_pose_with_covariance as do_transform_pose_with_covariance
from tfloom.tf2_ros.geometry import do_transform_pose_with_covariance_stamped as do_transform_pose_with_covariance_stamped
from tfloom.tf2_ros.geometry import do_transform_quaternion as do_transform_quaternion
from tfloom.tf2_ros.geometry import do_transform_quaternion_stamped as do_transform_quaternion_stamped
from tfloom.tf2_ros.geometry import do_transform_transform as do_transform_transform
from tfloom.tf2_ros.geometry import do_transform_transform_stamped as do_transform_transform_stamped
from tfloom.tf2_ros.geometry import do_transform_twist as do_transform_twist
from tfloom.tf2_ros.geometry import do_transform_twist_stamped as do_transform_twist_stamped
from tfloom.tf2_ros.geometry import do_transform_vector3 as do_transform_vector3
from tfloom.tf2_ros.geometry import do_transform_velocity_stamped as do_transform_velocity_stamped
from tfloom.tf2_ros.geometry import do_transform_wrench as do_transform_wrench
from tfloom.tf2_ros.geometry import do_transform_wrench_stamped as do_transform_wrench_stamped
from tfloom.tf2_ros.geometry import from_msg_msg as from_msg_msg
from tfloom.tf2_ros.geometry import to_msg_msg as to_msg_msg
from tfloom.tf2_ros.geometry import transform_covariance as transform_covariance
from tfloom.tf2_ros.geometry import value_of as value_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_geometry_msgs import tf2_geometry_msgs as tf2_geometry_msgs
    from tfloom.interfaces.geometry_msgs.msg import Point as Point
    from tfloom.interfaces.geometry_msgs.msg import Point32 as Point32
    from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
    from tfloom.interfaces.geometry_msgs.msg import PolygonStamped as PolygonStamped
    from tfloom.interfaces.geometry_msgs.msg import Pose as Pose
    from tfloom.interfaces.geometry_msgs.msg import PoseStamped as PoseStamped
    from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.geometry_msgs.msg import Vector3Stamped as Vector3Stamped
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Point="tfloom.interfaces.geometry_msgs.msg",
        Point32="tfloom.interfaces.geometry_msgs.msg",
        PointStamped="tfloom.interfaces.geometry_msgs.msg",
        PolygonStamped="tfloom.interfaces.geometry_msgs.msg",
        Pose="tfloom.interfaces.geometry_msgs.msg",
        PoseStamped="tfloom.interfaces.geometry_msgs.msg",
        PoseWithCovarianceStamped="tfloom.interfaces.geometry_msgs.msg",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
        Vector3Stamped="tfloom.interfaces.geometry_msgs.msg",
        tf2_geometry_msgs="tf2_geometry_msgs",
    )
