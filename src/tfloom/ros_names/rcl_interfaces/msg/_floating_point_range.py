"""The classes of rcl_interfaces/msg/FloatingPointRange, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import FloatingPointRange as FloatingPointRange
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FloatingPointRange

__all__ = ["Metaclass_FloatingPointRange", "FloatingPointRange"]
