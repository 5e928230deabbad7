"""The classes of moveit_msgs/msg/RobotState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import RobotState as RobotState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RobotState

__all__ = ["Metaclass_RobotState", "RobotState"]
