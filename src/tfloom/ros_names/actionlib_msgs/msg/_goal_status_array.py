"""The classes of actionlib_msgs/msg/GoalStatusArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.actionlib_msgs.msg import GoalStatusArray as GoalStatusArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GoalStatusArray

__all__ = ["Metaclass_GoalStatusArray", "GoalStatusArray"]
