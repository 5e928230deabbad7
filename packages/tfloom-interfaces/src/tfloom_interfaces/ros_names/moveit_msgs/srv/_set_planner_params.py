"""The classes of moveit_msgs/srv/SetPlannerParams, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import SetPlannerParams as SetPlannerParams
from tfloom_interfaces.interfaces.moveit_msgs.srv import SetPlannerParams_Event as SetPlannerParams_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import SetPlannerParams_Request as SetPlannerParams_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import SetPlannerParams_Response as SetPlannerParams_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPlannerParams
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPlannerParams_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPlannerParams_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPlannerParams_Response

__all__ = ["Metaclass_SetPlannerParams", "Metaclass_SetPlannerParams_Event", "Metaclass_SetPlannerParams_Request", "Metaclass_SetPlannerParams_Response", "SetPlannerParams", "SetPlannerParams_Event", "SetPlannerParams_Request", "SetPlannerParams_Response"]
