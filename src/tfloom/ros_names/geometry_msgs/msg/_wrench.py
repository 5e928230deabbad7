"""The classes of geometry_msgs/msg/Wrench, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Wrench as Wrench
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wrench

__all__ = ["Metaclass_Wrench", "Wrench"]
