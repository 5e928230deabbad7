"""The classes of control_msgs/msg/JointTrajectoryControllerState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import JointTrajectoryControllerState as JointTrajectoryControllerState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointTrajectoryControllerState

__all__ = ["Metaclass_JointTrajectoryControllerState", "JointTrajectoryControllerState"]
