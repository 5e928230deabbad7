"""The classes of example_interfaces/msg/Int64MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Int64MultiArray as Int64MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int64MultiArray

__all__ = ["Metaclass_Int64MultiArray", "Int64MultiArray"]
