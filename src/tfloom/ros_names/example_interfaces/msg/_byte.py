"""The classes of example_interfaces/msg/Byte, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import Byte as Byte
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Byte

__all__ = ["Metaclass_Byte", "Byte"]
