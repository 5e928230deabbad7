"""The classes of trajectory_msgs/msg/MultiDOFJointTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.trajectory_msgs.msg import MultiDOFJointTrajectory as MultiDOFJointTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiDOFJointTrajectory

__all__ = ["Metaclass_MultiDOFJointTrajectory", "MultiDOFJointTrajectory"]
