"""The classes of geometry_msgs/msg/PointStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointStamped

__all__ = ["Metaclass_PointStamped", "PointStamped"]
