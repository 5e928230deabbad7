"""The classes of actionlib_msgs/msg/GoalStatus, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.actionlib_msgs.msg import GoalStatus as GoalStatus
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GoalStatus

__all__ = ["Metaclass_GoalStatus", "GoalStatus"]
