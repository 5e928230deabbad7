"""The classes of geographic_msgs/msg/RoutePath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import RoutePath as RoutePath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RoutePath

__all__ = ["Metaclass_RoutePath", "RoutePath"]
