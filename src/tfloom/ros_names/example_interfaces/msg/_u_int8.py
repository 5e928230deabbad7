"""The classes of example_interfaces/msg/UInt8, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt8 as UInt8
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt8

__all__ = ["Metaclass_UInt8", "UInt8"]
