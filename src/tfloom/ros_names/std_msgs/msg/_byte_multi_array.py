"""The classes of std_msgs/msg/ByteMultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import ByteMultiArray as ByteMultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ByteMultiArray

__all__ = ["Metaclass_ByteMultiArray", "ByteMultiArray"]
