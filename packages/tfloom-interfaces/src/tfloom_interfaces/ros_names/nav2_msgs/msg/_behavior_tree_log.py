"""The classes of nav2_msgs/msg/BehaviorTreeLog, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import BehaviorTreeLog as BehaviorTreeLog
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BehaviorTreeLog

__all__ = ["Metaclass_BehaviorTreeLog", "BehaviorTreeLog"]
