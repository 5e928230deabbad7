"""The messages of geometry_msgs."""

from tfloom.interfaces.geometry_msgs.msg import *
from tfloom.interfaces.geometry_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from geometry_msgs.msg import _accel as _accel
    from geometry_msgs.msg import _accel_stamped as _accel_stamped
    from geometry_msgs.msg import _accel_with_covariance as _accel_with_covariance
    from geometry_msgs.msg import _accel_with_covariance_stamped as _accel_with_covariance_stamped
    from geometry_msgs.msg import _inertia as _inertia
    from geometry_msgs.msg import _inertia_stamped as _inertia_stamped
    from geometry_msgs.msg import _point as _point
    from geometry_msgs.msg import _point32 as _point32
    from geometry_msgs.msg import _point_stamped as _point_stamped
    from geometry_msgs.msg import _polygon as _polygon
    from geometry_msgs.msg import _polygon_instance as _polygon_instance
    from geometry_msgs.msg import _polygon_instance_stamped as _polygon_instance_stamped
    from geometry_msgs.msg import _polygon_stamped as _polygon_stamped
    from geometry_msgs.msg import _pose as _pose
    from geometry_msgs.msg import _pose2_d as _pose2_d
    from geometry_msgs.msg import _pose_array as _pose_array
    from geometry_msgs.msg import _pose_stamped as _pose_stamped
    from geometry_msgs.msg import _pose_with_covariance as _pose_with_covariance
    from geometry_msgs.msg import _pose_with_covariance_stamped as _pose_with_covariance_stamped
    from geometry_msgs.msg import _quaternion as _quaternion
    from geometry_msgs.msg import _quaternion_stamped as _quaternion_stamped
    from geometry_msgs.msg import _transform as _transform
    from geometry_msgs.msg import _transform_stamped as _transform_stamped
    from geometry_msgs.msg import _twist as _twist
    from geometry_msgs.msg import _twist_stamped as _twist_stamped
    from geometry_msgs.msg import _twist_with_covariance as _twist_with_covariance
    from geometry_msgs.msg import _twist_with_covariance_stamped as _twist_with_covariance_stamped
    from geometry_msgs.msg import _vector3 as _vector3
    from geometry_msgs.msg import _vector3_stamped as _vector3_stamped
    from geometry_msgs.msg import _velocity_stamped as _velocity_stamped
    from geometry_msgs.msg import _wrench as _wrench
    from geometry_msgs.msg import _wrench_stamped as _wrench_stamped
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("geometry_msgs.msg")
