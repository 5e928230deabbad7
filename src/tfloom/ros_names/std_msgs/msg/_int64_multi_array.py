"""The classes of std_msgs/msg/Int64MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int64MultiArray as Int64MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int64MultiArray

__all__ = ["Metaclass_Int64MultiArray", "Int64MultiArray"]
