"""The classes of moveit_msgs/srv/GetPlanningScene, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlanningScene as GetPlanningScene
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlanningScene_Event as GetPlanningScene_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlanningScene_Request as GetPlanningScene_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetPlanningScene_Response as GetPlanningScene_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlanningScene
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlanningScene_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlanningScene_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlanningScene_Response

__all__ = ["Metaclass_GetPlanningScene", "Metaclass_GetPlanningScene_Event", "Metaclass_GetPlanningScene_Request", "Metaclass_GetPlanningScene_Response", "GetPlanningScene", "GetPlanningScene_Event", "GetPlanningScene_Request", "GetPlanningScene_Response"]
