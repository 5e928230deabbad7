"""The classes of builtin_interfaces/msg/Time, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.builtin_interfaces.msg import Time as Time
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Time

__all__ = ["Metaclass_Time", "Time"]
