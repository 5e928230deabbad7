"""The classes of example_interfaces/msg/ByteMultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.msg import ByteMultiArray as ByteMultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ByteMultiArray

__all__ = ["Metaclass_ByteMultiArray", "ByteMultiArray"]
