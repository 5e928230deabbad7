"""The services of map_msgs."""

from tfloom_interfaces.interfaces.map_msgs.srv import *
from tfloom_interfaces.interfaces.map_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from map_msgs.srv import _get_map_roi as _get_map_roi
    from map_msgs.srv import _get_point_map as _get_point_map
    from map_msgs.srv import _get_point_map_roi as _get_point_map_roi
    from map_msgs.srv import _projected_maps_info as _projected_maps_info
    from map_msgs.srv import _save_map as _save_map
    from map_msgs.srv import _set_map_projections as _set_map_projections
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("map_msgs.srv")
