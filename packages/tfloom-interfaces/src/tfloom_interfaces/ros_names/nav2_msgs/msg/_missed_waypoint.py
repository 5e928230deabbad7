"""The classes of nav2_msgs/msg/MissedWaypoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import MissedWaypoint as MissedWaypoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MissedWaypoint

__all__ = ["Metaclass_MissedWaypoint", "MissedWaypoint"]
