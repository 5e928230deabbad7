"""The classes of nav2_msgs/msg/RouteNode, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import RouteNode as RouteNode
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RouteNode

__all__ = ["Metaclass_RouteNode", "RouteNode"]
