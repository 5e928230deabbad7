"""The classes of example_interfaces/msg/UInt64, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import UInt64 as UInt64
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UInt64

__all__ = ["Metaclass_UInt64", "UInt64"]
