"""The classes of nav2_msgs/srv/GetCostmap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCostmap as GetCostmap
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCostmap_Event as GetCostmap_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCostmap_Request as GetCostmap_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCostmap_Response as GetCostmap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCostmap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCostmap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCostmap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCostmap_Response

__all__ = ["Metaclass_GetCostmap", "Metaclass_GetCostmap_Event", "Metaclass_GetCostmap_Request", "Metaclass_GetCostmap_Response", "GetCostmap", "GetCostmap_Event", "GetCostmap_Request", "GetCostmap_Response"]
