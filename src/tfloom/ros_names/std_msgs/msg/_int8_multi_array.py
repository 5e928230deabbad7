"""The classes of std_msgs/msg/Int8MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int8MultiArray as Int8MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int8MultiArray

__all__ = ["Metaclass_Int8MultiArray", "Int8MultiArray"]
