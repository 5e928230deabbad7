"""The classes of map_msgs/srv/GetPointMapROI, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMapROI as GetPointMapROI
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMapROI_Event as GetPointMapROI_Event
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMapROI_Request as GetPointMapROI_Request
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMapROI_Response as GetPointMapROI_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMapROI
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMapROI_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMapROI_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMapROI_Response

__all__ = ["Metaclass_GetPointMapROI", "Metaclass_GetPointMapROI_Event", "Metaclass_GetPointMapROI_Request", "Metaclass_GetPointMapROI_Response", "GetPointMapROI", "GetPointMapROI_Event", "GetPointMapROI_Request", "GetPointMapROI_Response"]
