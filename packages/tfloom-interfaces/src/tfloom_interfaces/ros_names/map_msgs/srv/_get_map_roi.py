"""The classes of map_msgs/srv/GetMapROI, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.srv import GetMapROI as GetMapROI
from tfloom_interfaces.interfaces.map_msgs.srv import GetMapROI_Event as GetMapROI_Event
from tfloom_interfaces.interfaces.map_msgs.srv import GetMapROI_Request as GetMapROI_Request
from tfloom_interfaces.interfaces.map_msgs.srv import GetMapROI_Response as GetMapROI_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMapROI
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMapROI_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMapROI_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMapROI_Response

__all__ = ["Metaclass_GetMapROI", "Metaclass_GetMapROI_Event", "Metaclass_GetMapROI_Request", "Metaclass_GetMapROI_Response", "GetMapROI", "GetMapROI_Event", "GetMapROI_Request", "GetMapROI_Response"]
