"""The classes of map_msgs/msg/OccupancyGridUpdate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.msg import OccupancyGridUpdate as OccupancyGridUpdate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_OccupancyGridUpdate

__all__ = ["Metaclass_OccupancyGridUpdate", "OccupancyGridUpdate"]
