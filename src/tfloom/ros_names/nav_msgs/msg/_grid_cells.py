"""The classes of nav_msgs/msg/GridCells, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.msg import GridCells as GridCells
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GridCells

__all__ = ["Metaclass_GridCells", "GridCells"]
