"""The classes of vision_msgs/msg/BoundingBox3DArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import BoundingBox3DArray as BoundingBox3DArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBox3DArray

__all__ = ["Metaclass_BoundingBox3DArray", "BoundingBox3DArray"]
