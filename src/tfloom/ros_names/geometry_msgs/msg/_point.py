"""The classes of geometry_msgs/msg/Point, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Point as Point
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Point

__all__ = ["Metaclass_Point", "Point"]
