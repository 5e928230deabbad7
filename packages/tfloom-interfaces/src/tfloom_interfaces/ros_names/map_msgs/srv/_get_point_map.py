"""The classes of map_msgs/srv/GetPointMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMap as GetPointMap
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMap_Event as GetPointMap_Event
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMap_Request as GetPointMap_Request
from tfloom_interfaces.interfaces.map_msgs.srv import GetPointMap_Response as GetPointMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPointMap_Response

__all__ = ["Metaclass_GetPointMap", "Metaclass_GetPointMap_Event", "Metaclass_GetPointMap_Request", "Metaclass_GetPointMap_Response", "GetPointMap", "GetPointMap_Event", "GetPointMap_Request", "GetPointMap_Response"]
