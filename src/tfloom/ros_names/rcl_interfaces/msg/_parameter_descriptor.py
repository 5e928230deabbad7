"""The classes of rcl_interfaces/msg/ParameterDescriptor, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParameterDescriptor

__all__ = ["Metaclass_ParameterDescriptor", "ParameterDescriptor"]
