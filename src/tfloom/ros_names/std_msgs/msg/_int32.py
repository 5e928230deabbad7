"""The classes of std_msgs/msg/Int32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int32 as Int32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int32

__all__ = ["Metaclass_Int32", "Int32"]
