"""The classes of example_interfaces/msg/MultiArrayLayout, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import MultiArrayLayout as MultiArrayLayout
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiArrayLayout

__all__ = ["Metaclass_MultiArrayLayout", "MultiArrayLayout"]
