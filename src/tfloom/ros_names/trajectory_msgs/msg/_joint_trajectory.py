"""The classes of trajectory_msgs/msg/JointTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.trajectory_msgs.msg import JointTrajectory as JointTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointTrajectory

__all__ = ["Metaclass_JointTrajectory", "JointTrajectory"]
