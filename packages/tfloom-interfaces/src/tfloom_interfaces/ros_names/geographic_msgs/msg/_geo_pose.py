"""The classes of geographic_msgs/msg/GeoPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPose as GeoPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPose

__all__ = ["Metaclass_GeoPose", "GeoPose"]
