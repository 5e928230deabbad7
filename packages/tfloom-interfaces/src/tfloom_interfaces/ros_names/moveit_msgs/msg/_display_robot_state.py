"""The classes of moveit_msgs/msg/DisplayRobotState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import DisplayRobotState as DisplayRobotState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DisplayRobotState

__all__ = ["Metaclass_DisplayRobotState", "DisplayRobotState"]
