"""The classes of moveit_msgs/msg/RobotTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import RobotTrajectory as RobotTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RobotTrajectory

__all__ = ["Metaclass_RobotTrajectory", "RobotTrajectory"]
