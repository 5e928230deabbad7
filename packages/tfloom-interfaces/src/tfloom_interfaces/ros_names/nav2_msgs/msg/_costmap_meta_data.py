"""The classes of nav2_msgs/msg/CostmapMetaData, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import CostmapMetaData as CostmapMetaData
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CostmapMetaData

__all__ = ["Metaclass_CostmapMetaData", "CostmapMetaData"]
