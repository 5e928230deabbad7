"""The classes of example_interfaces/msg/Float64MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Float64MultiArray as Float64MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float64MultiArray

__all__ = ["Metaclass_Float64MultiArray", "Float64MultiArray"]
