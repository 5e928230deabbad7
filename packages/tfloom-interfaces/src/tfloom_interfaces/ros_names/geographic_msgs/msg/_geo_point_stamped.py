"""The classes of geographic_msgs/msg/GeoPointStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPointStamped as GeoPointStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPointStamped

__all__ = ["Metaclass_GeoPointStamped", "GeoPointStamped"]
