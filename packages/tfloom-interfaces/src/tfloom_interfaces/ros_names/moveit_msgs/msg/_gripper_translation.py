"""The classes of moveit_msgs/msg/GripperTranslation, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import GripperTranslation as GripperTranslation
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GripperTranslation

__all__ = ["Metaclass_GripperTranslation", "GripperTranslation"]
