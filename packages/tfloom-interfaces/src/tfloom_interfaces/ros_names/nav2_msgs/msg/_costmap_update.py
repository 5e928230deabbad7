"""The classes of nav2_msgs/msg/CostmapUpdate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import CostmapUpdate as CostmapUpdate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CostmapUpdate

__all__ = ["Metaclass_CostmapUpdate", "CostmapUpdate"]
