"""The classes of example_interfaces/msg/MultiArrayDimension, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import MultiArrayDimension as MultiArrayDimension
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiArrayDimension

__all__ = ["Metaclass_MultiArrayDimension", "MultiArrayDimension"]
