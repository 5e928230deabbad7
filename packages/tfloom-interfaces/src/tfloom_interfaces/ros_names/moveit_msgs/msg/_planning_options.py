"""The classes of moveit_msgs/msg/PlanningOptions, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlanningOptions as PlanningOptions
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlanningOptions

__all__ = ["Metaclass_PlanningOptions", "PlanningOptions"]
