"""The classes of moveit_msgs/srv/GetPlannerParams, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlannerParams as GetPlannerParams
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlannerParams_Event as GetPlannerParams_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlannerParams_Request as GetPlannerParams_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlannerParams_Response as GetPlannerParams_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlannerParams
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlannerParams_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlannerParams_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlannerParams_Response

__all__ = ["Metaclass_GetPlannerParams", "Metaclass_GetPlannerParams_Event", "Metaclass_GetPlannerParams_Request", "Metaclass_GetPlannerParams_Response", "GetPlannerParams", "GetPlannerParams_Event", "GetPlannerParams_Request", "GetPlannerParams_Response"]
