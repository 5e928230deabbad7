"""The classes of moveit_msgs/msg/MotionPlanRequest, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionPlanRequest as MotionPlanRequest
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionPlanRequest

__all__ = ["Metaclass_MotionPlanRequest", "MotionPlanRequest"]
