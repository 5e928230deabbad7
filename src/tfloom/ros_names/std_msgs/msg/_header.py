"""The classes of std_msgs/msg/Header, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Header as Header
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Header

__all__ = ["Metaclass_Header", "Header"]
