"""The classes of vision_msgs/msg/Point2D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Point2D as Point2D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Point2D

__all__ = ["Metaclass_Point2D", "Point2D"]
