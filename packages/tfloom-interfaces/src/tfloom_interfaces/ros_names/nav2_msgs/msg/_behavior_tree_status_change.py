"""The classes of nav2_msgs/msg/BehaviorTreeStatusChange, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import BehaviorTreeStatusChange as BehaviorTreeStatusChange
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BehaviorTreeStatusChange

__all__ = ["Metaclass_BehaviorTreeStatusChange", "BehaviorTreeStatusChange"]
