"""The classes of vision_msgs/msg/BoundingBox3D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import BoundingBox3D as BoundingBox3D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBox3D

__all__ = ["Metaclass_BoundingBox3D", "BoundingBox3D"]
