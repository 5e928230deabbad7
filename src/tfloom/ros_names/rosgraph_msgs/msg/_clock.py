"""The classes of rosgraph_msgs/msg/Clock, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosgraph_msgs.msg import Clock as Clock
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Clock

__all__ = ["Metaclass_Clock", "Clock"]
