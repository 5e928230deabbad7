"""The classes of nav_msgs/srv/GetMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.srv import GetMap as GetMap
from tfloom.interfaces.nav_msgs.srv import GetMap_Event as GetMap_Event
from tfloom.interfaces.nav_msgs.srv import GetMap_Request as GetMap_Request
from tfloom.interfaces.nav_msgs.srv import GetMap_Response as GetMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMap_Response

__all__ = ["Metaclass_GetMap", "Metaclass_GetMap_Event", "Metaclass_GetMap_Request", "Metaclass_GetMap_Response", "GetMap", "GetMap_Event", "GetMap_Request", "GetMap_Response"]
