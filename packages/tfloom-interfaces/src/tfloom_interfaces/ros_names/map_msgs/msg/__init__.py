"""The messages of map_msgs."""

from tfloom_interfaces.interfaces.map_msgs.msg import *
from tfloom_interfaces.interfaces.map_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from map_msgs.msg import _occupancy_grid_update as _occupancy_grid_update
    from map_msgs.msg import _point_cloud2_update as _point_cloud2_update
    from map_msgs.msg import _projected_map as _projected_map
    from map_msgs.msg import _projected_map_info as _projected_map_info
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("map_msgs.msg")
