"""The classes of moveit_msgs/msg/PlannerParams, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlannerParams as PlannerParams
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlannerParams

__all__ = ["Metaclass_PlannerParams", "PlannerParams"]
