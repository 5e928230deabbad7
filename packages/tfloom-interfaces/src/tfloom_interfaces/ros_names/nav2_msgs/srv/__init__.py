"""The services of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import *
from tfloom_interfaces.interfaces.nav2_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav2_msgs.srv import _clear_costmap_around_pose as _clear_costmap_around_pose
    from nav2_msgs.srv import _clear_costmap_around_robot as _clear_costmap_around_robot
    from nav2_msgs.srv import _clear_costmap_except_region as _clear_costmap_except_region
    from nav2_msgs.srv import _clear_entire_costmap as _clear_entire_costmap
    from nav2_msgs.srv import _dynamic_edges as _dynamic_edges
    from nav2_msgs.srv import _get_cost as _get_cost
    from nav2_msgs.srv import _get_costmap as _get_costmap
    from nav2_msgs.srv import _is_path_valid as _is_path_valid
    from nav2_msgs.srv import _load_map as _load_map
    from nav2_msgs.srv import _manage_lifecycle_nodes as _manage_lifecycle_nodes
    from nav2_msgs.srv import _reload_dock_database as _reload_dock_database
    from nav2_msgs.srv import _save_map as _save_map
    from nav2_msgs.srv import _set_initial_pose as _set_initial_pose
    from nav2_msgs.srv import _set_route_graph as _set_route_graph
    from nav2_msgs.srv import _toggle as _toggle
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav2_msgs.srv")
