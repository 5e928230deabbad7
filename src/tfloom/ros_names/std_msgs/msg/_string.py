"""The classes of std_msgs/msg/String, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import String as String
from tfloom.rosidl.class_modules import Metaclass as Metaclass_String

__all__ = ["Metaclass_String", "String"]
