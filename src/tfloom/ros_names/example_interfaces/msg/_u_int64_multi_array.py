"""The classes of example_interfaces/msg/UInt64MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt64MultiArray as UInt64MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt64MultiArray

__all__ = ["Metaclass_UInt64MultiArray", "UInt64MultiArray"]
