"""The classes of moveit_msgs/msg/Constraints, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import Constraints as Constraints
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Constraints

__all__ = ["Metaclass_Constraints", "Constraints"]
