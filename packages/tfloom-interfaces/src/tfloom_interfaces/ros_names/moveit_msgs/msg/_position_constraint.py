"""The classes of moveit_msgs/msg/PositionConstraint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PositionConstraint as PositionConstraint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PositionConstraint

__all__ = ["Metaclass_PositionConstraint", "PositionConstraint"]
