"""The classes of nav2_msgs/msg/CostmapFilterInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import CostmapFilterInfo as CostmapFilterInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CostmapFilterInfo

__all__ = ["Metaclass_CostmapFilterInfo", "CostmapFilterInfo"]
