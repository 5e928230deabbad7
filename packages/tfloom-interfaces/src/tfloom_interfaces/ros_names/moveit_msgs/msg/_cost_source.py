"""The classes of moveit_msgs/msg/CostSource, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import CostSource as CostSource
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CostSource

__all__ = ["Metaclass_CostSource", "CostSource"]
