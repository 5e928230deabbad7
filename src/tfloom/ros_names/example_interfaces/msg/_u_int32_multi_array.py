"""The classes of example_interfaces/msg/UInt32MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt32MultiArray as UInt32MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt32MultiArray

__all__ = ["Metaclass_UInt32MultiArray", "UInt32MultiArray"]
