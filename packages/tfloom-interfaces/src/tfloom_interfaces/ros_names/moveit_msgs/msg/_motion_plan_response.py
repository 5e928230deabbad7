"""The classes of moveit_msgs/msg/MotionPlanResponse, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionPlanResponse as MotionPlanResponse
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionPlanResponse

__all__ = ["Metaclass_MotionPlanResponse", "MotionPlanResponse"]
