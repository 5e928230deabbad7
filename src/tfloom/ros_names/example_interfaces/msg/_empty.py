"""The classes of example_interfaces/msg/Empty, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Empty as Empty
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty

__all__ = ["Metaclass_Empty", "Empty"]
