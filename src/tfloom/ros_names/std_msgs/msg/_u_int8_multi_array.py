"""The classes of std_msgs/msg/UInt8MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import UInt8MultiArray as UInt8MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt8MultiArray

__all__ = ["Metaclass_UInt8MultiArray", "UInt8MultiArray"]
