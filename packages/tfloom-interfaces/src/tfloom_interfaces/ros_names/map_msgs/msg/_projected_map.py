"""The classes of map_msgs/msg/ProjectedMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.msg import ProjectedMap as ProjectedMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMap

__all__ = ["Metaclass_ProjectedMap", "ProjectedMap"]
