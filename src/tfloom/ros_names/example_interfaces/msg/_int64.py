"""The classes of example_interfaces/msg/Int64, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Int64 as Int64
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int64

__all__ = ["Metaclass_Int64", "Int64"]
