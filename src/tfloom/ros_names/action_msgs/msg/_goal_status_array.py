"""The classes of action_msgs/msg/GoalStatusArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.action_msgs.msg import GoalStatusArray as GoalStatusArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GoalStatusArray

__all__ = ["Metaclass_GoalStatusArray", "GoalStatusArray"]
