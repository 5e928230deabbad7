"""The classes of example_interfaces/msg/Int8MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Int8MultiArray as Int8MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int8MultiArray

__all__ = ["Metaclass_Int8MultiArray", "Int8MultiArray"]
