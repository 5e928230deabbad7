"""The classes of geographic_msgs/msg/RouteSegment, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import RouteSegment as RouteSegment
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RouteSegment

__all__ = ["Metaclass_RouteSegment", "RouteSegment"]
