"""The classes of geometry_msgs/msg/Point32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Point32 as Point32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Point32

__all__ = ["Metaclass_Point32", "Point32"]
