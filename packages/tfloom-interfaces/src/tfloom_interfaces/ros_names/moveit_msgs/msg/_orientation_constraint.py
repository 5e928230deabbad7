"""The classes of moveit_msgs/msg/OrientationConstraint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import OrientationConstraint as OrientationConstraint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_OrientationConstraint

__all__ = ["Metaclass_OrientationConstraint", "OrientationConstraint"]
