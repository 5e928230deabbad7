"""The classes of geographic_msgs/msg/GeoPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPoint as GeoPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPoint

__all__ = ["Metaclass_GeoPoint", "GeoPoint"]
