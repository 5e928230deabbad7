"""The classes of moveit_msgs/msg/OrientedBoundingBox, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import OrientedBoundingBox as OrientedBoundingBox
from tfloom.rosidl.class_modules import Metaclass as Metaclass_OrientedBoundingBox

__all__ = ["Metaclass_OrientedBoundingBox", "OrientedBoundingBox"]
