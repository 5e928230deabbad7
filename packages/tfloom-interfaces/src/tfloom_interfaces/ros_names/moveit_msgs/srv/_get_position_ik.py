"""The classes of moveit_msgs/srv/GetPositionIK, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionIK as GetPositionIK
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionIK_Event as GetPositionIK_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionIK_Request as GetPositionIK_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPositionIK_Response as GetPositionIK_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionIK
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionIK_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionIK_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPositionIK_Response

__all__ = ["Metaclass_GetPositionIK", "Metaclass_GetPositionIK_Event", "Metaclass_GetPositionIK_Request", "Metaclass_GetPositionIK_Response", "GetPositionIK", "GetPositionIK_Event", "GetPositionIK_Request", "GetPositionIK_Response"]
