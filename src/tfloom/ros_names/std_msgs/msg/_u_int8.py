"""The classes of std_msgs/msg/UInt8, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import UInt8 as UInt8
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt8

__all__ = ["Metaclass_UInt8", "UInt8"]
