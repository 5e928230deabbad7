"""The classes of moveit_msgs/msg/JointLimits, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import JointLimits as JointLimits
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointLimits

__all__ = ["Metaclass_JointLimits", "JointLimits"]
