"""The classes of geographic_msgs/msg/MapFeature, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import MapFeature as MapFeature
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MapFeature

__all__ = ["Metaclass_MapFeature", "MapFeature"]
