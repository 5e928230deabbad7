"""The classes of example_interfaces/msg/String, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import String as String
from tfloom.rosidl.class_modules import Metaclass as Metaclass_String

__all__ = ["Metaclass_String", "String"]
