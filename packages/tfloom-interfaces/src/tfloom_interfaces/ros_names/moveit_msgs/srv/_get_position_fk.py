"""The classes of moveit_msgs/srv/GetPositionFK, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionFK as GetPositionFK
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionFK_Event as GetPositionFK_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionFK_Request as GetPositionFK_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionFK_Response as GetPositionFK_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionFK
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionFK_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionFK_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionFK_Response

__all__ = ["Metaclass_GetPositionFK", "Metaclass_GetPositionFK_Event", "Metaclass_GetPositionFK_Request", "Metaclass_GetPositionFK_Response", "GetPositionFK", "GetPositionFK_Event", "GetPositionFK_Request", "GetPositionFK_Response"]
