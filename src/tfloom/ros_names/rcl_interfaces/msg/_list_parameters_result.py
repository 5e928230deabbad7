"""The classes of rcl_interfaces/msg/ListParametersResult, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ListParametersResult as ListParametersResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListParametersResult

__all__ = ["Metaclass_ListParametersResult", "ListParametersResult"]
