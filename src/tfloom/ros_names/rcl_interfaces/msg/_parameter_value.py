"""The classes of rcl_interfaces/msg/ParameterValue, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterValue as ParameterValue
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParameterValue

__all__ = ["Metaclass_ParameterValue", "ParameterValue"]
