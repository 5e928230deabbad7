"""The classes of vision_msgs/msg/BoundingBox2D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import BoundingBox2D as BoundingBox2D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBox2D

__all__ = ["Metaclass_BoundingBox2D", "BoundingBox2D"]
