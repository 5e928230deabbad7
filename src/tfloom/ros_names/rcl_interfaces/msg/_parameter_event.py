"""The classes of rcl_interfaces/msg/ParameterEvent, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent as ParameterEvent
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParameterEvent

__all__ = ["Metaclass_ParameterEvent", "ParameterEvent"]
