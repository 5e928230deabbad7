"""The classes of example_interfaces/msg/Float32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Float32 as Float32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float32

__all__ = ["Metaclass_Float32", "Float32"]
