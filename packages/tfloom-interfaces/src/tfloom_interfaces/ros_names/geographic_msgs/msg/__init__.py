"""The messages of geographic_msgs."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import *
from tfloom_interfaces.interfaces.geographic_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from geographic_msgs.msg import _bounding_box as _bounding_box
    from geographic_msgs.msg import _geo_path as _geo_path
    from geographic_msgs.msg import _geo_point as _geo_point
    from geographic_msgs.msg import _geo_point_stamped as _geo_point_stamped
    from geographic_msgs.msg import _geo_pose as _geo_pose
    from geographic_msgs.msg import _geo_pose_stamped as _geo_pose_stamped
    from geographic_msgs.msg import _geo_pose_with_covariance as _geo_pose_with_covariance
    from geographic_msgs.msg import _geo_pose_with_covariance_stamped as _geo_pose_with_covariance_stamped
    from geographic_msgs.msg import _geographic_map as _geographic_map
    from geographic_msgs.msg import _geographic_map_changes as _geographic_map_changes
    from geographic_msgs.msg import _key_value as _key_value
    from geographic_msgs.msg import _map_feature as _map_feature
    from geographic_msgs.msg import _route_network as _route_network
    from geographic_msgs.msg import _route_path as _route_path
    from geographic_msgs.msg import _route_segment as _route_segment
    from geographic_msgs.msg import _way_point as _way_point
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("geographic_msgs.msg")
