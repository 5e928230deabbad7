"""The messages of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import *
from tfloom_interfaces.interfaces.nav2_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav2_msgs.msg import _behavior_tree_log as _behavior_tree_log
    from nav2_msgs.msg import _behavior_tree_status_change as _behavior_tree_status_change
    from nav2_msgs.msg import _collision_detector_state as _collision_detector_state
    from nav2_msgs.msg import _collision_monitor_state as _collision_monitor_state
    from nav2_msgs.msg import _costmap as _costmap
    from nav2_msgs.msg import _costmap_filter_info as _costmap_filter_info
    from nav2_msgs.msg import _costmap_meta_data as _costmap_meta_data
    from nav2_msgs.msg import _costmap_update as _costmap_update
    from nav2_msgs.msg import _edge_cost as _edge_cost
    from nav2_msgs.msg import _missed_waypoint as _missed_waypoint
    from nav2_msgs.msg import _particle as _particle
    from nav2_msgs.msg import _particle_cloud as _particle_cloud
    from nav2_msgs.msg import _route as _route
    from nav2_msgs.msg import _route_edge as _route_edge
    from nav2_msgs.msg import _route_node as _route_node
    from nav2_msgs.msg import _speed_limit as _speed_limit
    from nav2_msgs.msg import _voxel_grid as _voxel_grid
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav2_msgs.msg")
