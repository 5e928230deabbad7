"""The classes of nav_msgs/msg/OccupancyGrid, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.msg import OccupancyGrid as OccupancyGrid
from tfloom.rosidl.class_modules import Metaclass as Metaclass_OccupancyGrid

__all__ = ["Metaclass_OccupancyGrid", "OccupancyGrid"]
