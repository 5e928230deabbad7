"""The classes of rcl_interfaces/msg/LoggerLevel, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import LoggerLevel as LoggerLevel
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoggerLevel

__all__ = ["Metaclass_LoggerLevel", "LoggerLevel"]
