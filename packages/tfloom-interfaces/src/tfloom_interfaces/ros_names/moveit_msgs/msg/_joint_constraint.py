"""The classes of moveit_msgs/msg/JointConstraint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import JointConstraint as JointConstraint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointConstraint

__all__ = ["Metaclass_JointConstraint", "JointConstraint"]
