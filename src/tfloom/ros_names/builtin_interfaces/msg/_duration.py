"""The classes of builtin_interfaces/msg/Duration, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.builtin_interfaces.msg import Duration as Duration
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Duration

__all__ = ["Metaclass_Duration", "Duration"]
