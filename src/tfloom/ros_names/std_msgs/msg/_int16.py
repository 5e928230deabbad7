"""The classes of std_msgs/msg/Int16, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Int16 as Int16
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Int16

__all__ = ["Metaclass_Int16", "Int16"]
