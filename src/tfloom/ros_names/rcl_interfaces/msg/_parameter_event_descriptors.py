"""The classes of rcl_interfaces/msg/ParameterEventDescriptors, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterEventDescriptors as ParameterEventDescriptors
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParameterEventDescriptors

__all__ = ["Metaclass_ParameterEventDescriptors", "ParameterEventDescriptors"]
