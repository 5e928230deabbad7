"""The classes of rcl_interfaces/msg/Log, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import Log as Log
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Log

__all__ = ["Metaclass_Log", "Log"]
