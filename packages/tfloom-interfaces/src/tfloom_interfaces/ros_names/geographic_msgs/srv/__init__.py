"""The services of geographic_msgs."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import *
from tfloom_interfaces.interfaces.geographic_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from geographic_msgs.srv import _get_geo_path as _get_geo_path
    from geographic_msgs.srv import _get_geographic_map as _get_geographic_map
    from geographic_msgs.srv import _get_route_plan as _get_route_plan
    from geographic_msgs.srv import _update_geographic_map as _update_geographic_map
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("geographic_msgs.srv")
