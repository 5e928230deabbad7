"""The classes of moveit_msgs/srv/GetGroupUrdf, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetGroupUrdf as GetGroupUrdf
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetGroupUrdf_Event as GetGroupUrdf_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetGroupUrdf_Request as GetGroupUrdf_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetGroupUrdf_Response as GetGroupUrdf_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGroupUrdf
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGroupUrdf_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGroupUrdf_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGroupUrdf_Response

__all__ = ["Metaclass_GetGroupUrdf", "Metaclass_GetGroupUrdf_Event", "Metaclass_GetGroupUrdf_Request", "Metaclass_GetGroupUrdf_Response", "GetGroupUrdf", "GetGroupUrdf_Event", "GetGroupUrdf_Request", "GetGroupUrdf_Response"]
