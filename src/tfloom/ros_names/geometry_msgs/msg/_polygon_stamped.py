"""The classes of geometry_msgs/msg/PolygonStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PolygonStamped as PolygonStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PolygonStamped

__all__ = ["Metaclass_PolygonStamped", "PolygonStamped"]
