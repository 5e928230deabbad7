"""The classes of moveit_msgs/srv/GetCartesianPath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetCartesianPath as GetCartesianPath
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetCartesianPath_Event as GetCartesianPath_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetCartesianPath_Request as GetCartesianPath_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetCartesianPath_Response as GetCartesianPath_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCartesianPath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCartesianPath_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCartesianPath_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCartesianPath_Response

__all__ = ["Metaclass_GetCartesianPath", "Metaclass_GetCartesianPath_Event", "Metaclass_GetCartesianPath_Request", "Metaclass_GetCartesianPath_Response", "GetCartesianPath", "GetCartesianPath_Event", "GetCartesianPath_Request", "GetCartesianPath_Response"]
