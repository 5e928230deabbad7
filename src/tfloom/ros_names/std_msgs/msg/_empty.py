"""The classes of std_msgs/msg/Empty, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Empty as Empty
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty

__all__ = ["Metaclass_Empty", "Empty"]
