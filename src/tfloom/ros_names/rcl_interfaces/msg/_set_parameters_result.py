"""The classes of rcl_interfaces/msg/SetParametersResult, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParametersResult

__all__ = ["Metaclass_SetParametersResult", "SetParametersResult"]
