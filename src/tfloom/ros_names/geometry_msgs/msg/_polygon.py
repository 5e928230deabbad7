"""The classes of geometry_msgs/msg/Polygon, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Polygon as Polygon
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Polygon

__all__ = ["Metaclass_Polygon", "Polygon"]
