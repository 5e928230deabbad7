"""The classes of map_msgs/msg/ProjectedMapInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.msg import ProjectedMapInfo as ProjectedMapInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMapInfo

__all__ = ["Metaclass_ProjectedMapInfo", "ProjectedMapInfo"]
