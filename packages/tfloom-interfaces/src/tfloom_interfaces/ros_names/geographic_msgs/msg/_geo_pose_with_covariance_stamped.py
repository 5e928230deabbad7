"""The classes of geographic_msgs/msg/GeoPoseWithCovarianceStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPoseWithCovarianceStamped as GeoPoseWithCovarianceStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPoseWithCovarianceStamped

__all__ = ["Metaclass_GeoPoseWithCovarianceStamped", "GeoPoseWithCovarianceStamped"]
