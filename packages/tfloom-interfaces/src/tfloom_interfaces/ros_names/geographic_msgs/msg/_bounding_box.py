"""The classes of geographic_msgs/msg/BoundingBox, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import BoundingBox as BoundingBox
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBox

__all__ = ["Metaclass_BoundingBox", "BoundingBox"]
