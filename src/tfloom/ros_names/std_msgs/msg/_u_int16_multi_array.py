"""The classes of std_msgs/msg/UInt16MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import UInt16MultiArray as UInt16MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt16MultiArray

__all__ = ["Metaclass_UInt16MultiArray", "UInt16MultiArray"]
