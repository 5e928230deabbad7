"""The classes of actionlib_msgs/msg/GoalID, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.actionlib_msgs.msg import GoalID as GoalID
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GoalID

__all__ = ["Metaclass_GoalID", "GoalID"]
