"""The classes of geometry_msgs/msg/PolygonInstanceStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PolygonInstanceStamped as PolygonInstanceStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PolygonInstanceStamped

__all__ = ["Metaclass_PolygonInstanceStamped", "PolygonInstanceStamped"]
