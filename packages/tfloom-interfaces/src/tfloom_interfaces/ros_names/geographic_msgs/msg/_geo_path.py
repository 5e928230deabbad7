"""The classes of geographic_msgs/msg/GeoPath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPath as GeoPath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPath

__all__ = ["Metaclass_GeoPath", "GeoPath"]
