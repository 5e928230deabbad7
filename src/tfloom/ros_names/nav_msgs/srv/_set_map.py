"""The classes of nav_msgs/srv/SetMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.srv import SetMap as SetMap
from tfloom.interfaces.nav_msgs.srv import SetMap_Event as SetMap_Event
from tfloom.interfaces.nav_msgs.srv import SetMap_Request as SetMap_Request
from tfloom.interfaces.nav_msgs.srv import SetMap_Response as SetMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMap_Response

__all__ = ["Metaclass_SetMap", "Metaclass_SetMap_Event", "Metaclass_SetMap_Request", "Metaclass_SetMap_Response", "SetMap", "SetMap_Event", "SetMap_Request", "SetMap_Response"]
