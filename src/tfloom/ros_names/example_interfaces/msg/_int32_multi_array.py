"""The classes of example_interfaces/msg/Int32MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Int32MultiArray as Int32MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int32MultiArray

__all__ = ["Metaclass_Int32MultiArray", "Int32MultiArray"]
