"""The classes of std_msgs/msg/UInt16, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import UInt16 as UInt16
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt16

__all__ = ["Metaclass_UInt16", "UInt16"]
