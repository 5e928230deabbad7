"""The classes of std_msgs/msg/UInt32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import UInt32 as UInt32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt32

__all__ = ["Metaclass_UInt32", "UInt32"]
