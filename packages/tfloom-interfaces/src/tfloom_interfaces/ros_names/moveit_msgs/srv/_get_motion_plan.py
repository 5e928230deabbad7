"""The classes of moveit_msgs/srv/GetMotionPlan, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionPlan as GetMotionPlan
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionPlan_Event as GetMotionPlan_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionPlan_Request as GetMotionPlan_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionPlan_Response as GetMotionPlan_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionPlan
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionPlan_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionPlan_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionPlan_Response

__all__ = ["Metaclass_GetMotionPlan", "Metaclass_GetMotionPlan_Event", "Metaclass_GetMotionPlan_Request", "Metaclass_GetMotionPlan_Response", "GetMotionPlan", "GetMotionPlan_Event", "GetMotionPlan_Request", "GetMotionPlan_Response"]
