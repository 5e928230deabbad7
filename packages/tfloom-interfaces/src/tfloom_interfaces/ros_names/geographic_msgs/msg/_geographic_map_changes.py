"""The classes of geographic_msgs/msg/GeographicMapChanges, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeographicMapChanges as GeographicMapChanges
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeographicMapChanges

__all__ = ["Metaclass_GeographicMapChanges", "GeographicMapChanges"]
