"""The classes of geographic_msgs/msg/GeoPoseStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import GeoPoseStamped as GeoPoseStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GeoPoseStamped

__all__ = ["Metaclass_GeoPoseStamped", "GeoPoseStamped"]
