"""The classes of nav2_msgs/msg/Route, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import Route as Route
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Route

__all__ = ["Metaclass_Route", "Route"]
