"""The classes of action_msgs/msg/GoalInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.action_msgs.msg import GoalInfo as GoalInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GoalInfo

__all__ = ["Metaclass_GoalInfo", "GoalInfo"]
