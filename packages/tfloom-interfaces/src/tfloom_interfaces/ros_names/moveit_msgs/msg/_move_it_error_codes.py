"""The classes of moveit_msgs/msg/MoveItErrorCodes, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MoveItErrorCodes as MoveItErrorCodes
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveItErrorCodes

__all__ = ["Metaclass_MoveItErrorCodes", "MoveItErrorCodes"]
