"""The classes of example_interfaces/msg/Int16MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Int16MultiArray as Int16MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int16MultiArray

__all__ = ["Metaclass_Int16MultiArray", "Int16MultiArray"]
