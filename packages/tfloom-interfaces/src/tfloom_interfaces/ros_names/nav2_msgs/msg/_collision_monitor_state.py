"""The classes of nav2_msgs/msg/CollisionMonitorState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import CollisionMonitorState as CollisionMonitorState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CollisionMonitorState

__all__ = ["Metaclass_CollisionMonitorState", "CollisionMonitorState"]
