"""The classes of vision_msgs/msg/BoundingBox2DArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import BoundingBox2DArray as BoundingBox2DArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBox2DArray

__all__ = ["Metaclass_BoundingBox2DArray", "BoundingBox2DArray"]
