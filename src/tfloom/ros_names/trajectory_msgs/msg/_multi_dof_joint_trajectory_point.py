"""The classes of trajectory_msgs/msg/MultiDOFJointTrajectoryPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.trajectory_msgs.msg import MultiDOFJointTrajectoryPoint as MultiDOFJointTrajectoryPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiDOFJointTrajectoryPoint

__all__ = ["Metaclass_MultiDOFJointTrajectoryPoint", "MultiDOFJointTrajectoryPoint"]
