"""The classes of example_interfaces/msg/Bool, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Bool as Bool
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Bool

__all__ = ["Metaclass_Bool", "Bool"]
