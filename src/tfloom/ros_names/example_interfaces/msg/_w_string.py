"""The classes of example_interfaces/msg/WString, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import WString as WString
from tfloom.rosidl.class_modules import Metaclass as Metaclass_WString

__all__ = ["Metaclass_WString", "WString"]
