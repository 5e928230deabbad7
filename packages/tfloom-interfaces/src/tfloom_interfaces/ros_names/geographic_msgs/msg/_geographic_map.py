"""The classes of geographic_msgs/msg/GeographicMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeographicMap as GeographicMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeographicMap

__all__ = ["Metaclass_GeographicMap", "GeographicMap"]
