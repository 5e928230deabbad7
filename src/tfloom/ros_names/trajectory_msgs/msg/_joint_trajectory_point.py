"""The classes of trajectory_msgs/msg/JointTrajectoryPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.trajectory_msgs.msg import JointTrajectoryPoint as JointTrajectoryPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointTrajectoryPoint

__all__ = ["Metaclass_JointTrajectoryPoint", "JointTrajectoryPoint"]
