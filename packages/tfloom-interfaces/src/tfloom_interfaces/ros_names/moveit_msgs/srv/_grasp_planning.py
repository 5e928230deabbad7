"""The classes of moveit_msgs/srv/GraspPlanning, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GraspPlanning as GraspPlanning
from tfloom_interfaces.interfaces.moveit_msgs.srv import GraspPlanning_Event as GraspPlanning_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GraspPlanning_Request as GraspPlanning_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GraspPlanning_Response as GraspPlanning_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GraspPlanning
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GraspPlanning_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GraspPlanning_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GraspPlanning_Response

__all__ = ["Metaclass_GraspPlanning", "Metaclass_GraspPlanning_Event", "Metaclass_GraspPlanning_Request", "Metaclass_GraspPlanning_Response", "GraspPlanning", "GraspPlanning_Event", "GraspPlanning_Request", "GraspPlanning_Response"]
