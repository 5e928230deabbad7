"""The classes of rcl_interfaces/msg/ParameterType, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParameterType

__all__ = ["Metaclass_ParameterType", "ParameterType"]
