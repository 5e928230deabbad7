"""The classes of rcl_interfaces/msg/Parameter, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import Parameter as Parameter
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Parameter

__all__ = ["Metaclass_Parameter", "Parameter"]
