"""The classes of geographic_msgs/msg/WayPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import WayPoint as WayPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_WayPoint

__all__ = ["Metaclass_WayPoint", "WayPoint"]
