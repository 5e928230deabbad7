"""The classes of example_interfaces/msg/UInt16MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt16MultiArray as UInt16MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt16MultiArray

__all__ = ["Metaclass_UInt16MultiArray", "UInt16MultiArray"]
