"""The classes of nav2_msgs/msg/RouteEdge, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import RouteEdge as RouteEdge
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RouteEdge

__all__ = ["Metaclass_RouteEdge", "RouteEdge"]
