"""The classes of std_msgs/msg/Int8, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int8 as Int8
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int8

__all__ = ["Metaclass_Int8", "Int8"]
