"""The classes of example_interfaces/msg/UInt8MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt8MultiArray as UInt8MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt8MultiArray

__all__ = ["Metaclass_UInt8MultiArray", "UInt8MultiArray"]
