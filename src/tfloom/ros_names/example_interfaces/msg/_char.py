"""The classes of example_interfaces/msg/Char, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Char as Char
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Char

__all__ = ["Metaclass_Char", "Char"]
