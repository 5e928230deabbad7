"""The classes of rcl_interfaces/msg/SetLoggerLevelsResult, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import SetLoggerLevelsResult as SetLoggerLevelsResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetLoggerLevelsResult

__all__ = ["Metaclass_SetLoggerLevelsResult", "SetLoggerLevelsResult"]
