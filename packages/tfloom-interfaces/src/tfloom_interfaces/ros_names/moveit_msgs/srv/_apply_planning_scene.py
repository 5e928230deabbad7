"""The classes of moveit_msgs/srv/ApplyPlanningScene, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import ApplyPlanningScene as ApplyPlanningScene
from tfloom_interfaces.interfaces.moveit_msgs.srv import ApplyPlanningScene_Event as ApplyPlanningScene_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import ApplyPlanningScene_Request as ApplyPlanningScene_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import ApplyPlanningScene_Response as ApplyPlanningScene_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ApplyPlanningScene
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ApplyPlanningScene_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ApplyPlanningScene_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ApplyPlanningScene_Response

__all__ = ["Metaclass_ApplyPlanningScene", "Metaclass_ApplyPlanningScene_Event", "Metaclass_ApplyPlanningScene_Request", "Metaclass_ApplyPlanningScene_Response", "ApplyPlanningScene", "ApplyPlanningScene_Event", "ApplyPlanningScene_Request", "ApplyPlanningScene_Response"]
