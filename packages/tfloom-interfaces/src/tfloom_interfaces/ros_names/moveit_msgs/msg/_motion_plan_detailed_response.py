"""The classes of moveit_msgs/msg/MotionPlanDetailedResponse, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionPlanDetailedResponse as MotionPlanDetailedResponse
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionPlanDetailedResponse

__all__ = ["Metaclass_MotionPlanDetailedResponse", "MotionPlanDetailedResponse"]
