"""The classes of std_msgs/msg/Int64, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int64 as Int64
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int64

__all__ = ["Metaclass_Int64", "Int64"]
