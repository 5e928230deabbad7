"""The classes of geographic_msgs/msg/RouteNetwork, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import RouteNetwork as RouteNetwork
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RouteNetwork

__all__ = ["Metaclass_RouteNetwork", "RouteNetwork"]
