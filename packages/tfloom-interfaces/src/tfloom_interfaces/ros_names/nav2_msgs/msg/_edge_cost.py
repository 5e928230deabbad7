"""The classes of nav2_msgs/msg/EdgeCost, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import EdgeCost as EdgeCost
from tfloom.rosidl.class_modules import Metaclass as Metaclass_EdgeCost

__all__ = ["Metaclass_EdgeCost", "EdgeCost"]
