"""The classes of geographic_msgs/msg/GeoPoseWithCovariance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPoseWithCovariance as GeoPoseWithCovariance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPoseWithCovariance

__all__ = ["Metaclass_GeoPoseWithCovariance", "GeoPoseWithCovariance"]
