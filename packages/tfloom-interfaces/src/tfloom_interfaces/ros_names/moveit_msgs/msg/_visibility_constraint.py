"""The classes of moveit_msgs/msg/VisibilityConstraint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import VisibilityConstraint as VisibilityConstraint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VisibilityConstraint

__all__ = ["Metaclass_VisibilityConstraint", "VisibilityConstraint"]
