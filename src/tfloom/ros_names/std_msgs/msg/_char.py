"""The classes of std_msgs/msg/Char, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Char as Char
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Char

__all__ = ["Metaclass_Char", "Char"]
