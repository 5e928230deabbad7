"""The classes of rcl_interfaces/msg/IntegerRange, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.msg import IntegerRange as IntegerRange
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IntegerRange

__all__ = ["Metaclass_IntegerRange", "IntegerRange"]
